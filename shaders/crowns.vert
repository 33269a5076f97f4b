// SPDX-License-Identifier: MIT
// The crowns of all trees on a square of ground, as a picture that faces the eye.
// osg_Vertex: s in [-1, 1] across the picture, t in [0, 1] up it.

#include "light.glsl"
#include "surface.glsl"

in vec4 treePlace; // middle of the square on the ground; its side, metres
in vec4 treeSize;  // number of trees; their height and crown width, metres; species

uniform vec4 crownColors[128]; // by species; alpha: share of the leaves

flat out vec4 crownGrid;  // width of a crown, share of cells of this width with a crown, number of the square, height
flat out vec4 crownColor;
flat out vec3 crownLight; // linearLight() of leaves, without the term of the normal
flat out mat3 lightByNormal;
flat out vec3 crownToEye; // in eye space, as the axes of the picture
flat out vec3 crownAcross;
flat out vec3 crownUp;
#ifdef SHADOWED
flat out vec3 crownSunScattering;
flat out vec3 crownSunWay;
#endif
out vec2 crownPlace; // metres on the picture
out vec3 crownEye;

void main() {
    bool parallel = osg_ProjectionMatrix[3][3] > 0.5;
    vec3 middle = treePlace.xyz + vec3(0.0, 0.0, 0.5 * treeSize.y);
    vec3 eye = parallel ? vec3(0.0, 0.0, 1.0) : -vec3(osg_ModelViewMatrix * vec4(middle, 1.0));
    vec3 toEye = normalize(eye * osg_NormalMatrix);
    float level = length(toEye.xy);
    vec2 ahead = level > 1e-4 ? toEye.xy / level : vec2(1.0, 0.0);
    vec3 across = vec3(-ahead.y, ahead.x, 0.0), up = vec3(-ahead * toEye.z, level);

    // The picture reaches from the near edge of the ground to the tops of the trees at the far edge.
    float half_ = 0.5 * treePlace.w, depth = half_ * abs(toEye.z);
    float low = -depth, high = depth + treeSize.y * level;
    crownPlace = vec2(osg_Vertex.x * half_, mix(low, high, osg_Vertex.y));
    float squares = treePlace.w * (high - low) / (treeSize.z * treeSize.z);
    float own = fract(dot(treePlace.xy, vec2(0.0754878, 0.0569840)));
    crownGrid = vec4(treeSize.z, treeSize.x / max(squares, 1e-3), own, treeSize.y);
    crownColor = crownColors[int(treeSize.w + 0.5)];

    vec4 eyePosition = osg_ModelViewMatrix * vec4(treePlace.xyz + crownPlace.x * across + crownPlace.y * up, 1.0);
    crownEye = eyePosition.xyz;
    vec3 leafMore, sunScattering, sunWay;
    linearLight((osg_ModelViewMatrix * vec4(middle, 1.0)).xyz, crownLight, leafMore, lightByNormal, sunScattering, sunWay);
    crownLight += leafMore;
    crownToEye = normalize(osg_NormalMatrix * toEye);
    crownAcross = normalize(osg_NormalMatrix * across);
    crownUp = normalize(osg_NormalMatrix * up);
#ifdef SHADOWED
    crownSunScattering = sunScattering;
    crownSunWay = sunWay;
#endif
    placeSurface(eyePosition, crownToEye, own);
}
