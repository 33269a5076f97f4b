// SPDX-License-Identifier: MIT
// The impostor of a tree: a picture that faces the eye and leans as the tree does.
// osg_Vertex: s in [-1, 1] across the picture, t in [0, 1] up it.

#include "law/tint.glsl"
#include "light.glsl"
#include "surface.glsl"

in vec4 treePlace; // foot, heading
in vec4 treeSize;  // scales across and along the trunk; horizontal rotation vector of a fallen tree
in vec4 treeState; // lean of the top (x, y), fade, number of the tree
in vec4 treeLight; // share of light that neighbours leave at the foot and at the top

uniform vec4 impostorSize;       // half width and height of the unscaled tree; numbers of azimuths and elevations
uniform vec2 impostorExtents[8]; // lowest and highest point in the pictures of an elevation, from the foot
uniform float leanPower;         // exponent of the height in the lean

flat out vec4 pictureViews; // columns and rows of the nearest pictures
flat out vec4 pictureParts; // shares of the second column and row; fade; number of the tree
flat out vec3 barkLight;    // linearLight(), for normals in the tree's frame
flat out vec3 leafLightMore;
flat out mat3 lightByNormal;
#ifdef SHADOWED
flat out vec3 pictureSunScattering;
flat out vec3 pictureSunWay;
out vec3 pictureFront; // of the crown, where it takes shadows
#endif
out vec2 pictureCoord;
out float pictureLeft; // share of the light that neighbours leave
out vec3 pictureEye;

const float margin = 1.0 / 16.0; // ImpostorPictures::margin
const float quarter = 1.57079633;

/// Direction from a point to the eye, in the forest's frame.
vec3 towardEye(vec3 point) {
    bool parallel = osg_ProjectionMatrix[3][3] > 0.5;
    vec3 eye = parallel ? vec3(0.0, 0.0, 1.0) : -vec3(osg_ModelViewMatrix * vec4(point, 1.0));
    return normalize(eye * osg_NormalMatrix); // by the inverse of the model-view matrix
}

/// Rotation of a fallen tree from its standing position.
mat3 fallen() {
    float angle = length(treeSize.zw);
    if (angle == 0.0)
        return mat3(1.0);
    vec2 a = treeSize.zw / angle;
    float s = sin(angle), c = cos(angle);
    return mat3(c + a.x * a.x * (1.0 - c), a.x * a.y * (1.0 - c), -a.y * s,
                a.x * a.y * (1.0 - c), c + a.y * a.y * (1.0 - c), a.x * s,
                a.y * s, -a.x * s, c);
}

void main() {
    vec2 scale = treeSize.xy;
    float height = impostorSize.y * scale.y;
    mat3 down = fallen();
    vec3 toEye = towardEye(treePlace.xyz + down * vec3(0.5 * treeState.xy, 0.5 * height)) * down;
    float level = length(toEye.xy);
    vec2 ahead = level > 1e-4 ? toEye.xy / level : vec2(1.0, 0.0);
    vec3 up = vec3(-ahead * toEye.z, level);

    // The nearest pictures, for the view direction in the frame of the unscaled tree.
    float column = (atan(ahead.y, ahead.x) - treePlace.w) / (4.0 * quarter) * impostorSize.z;
    float rows = impostorSize.w - 1.0;
    float row = clamp(atan(scale.x * toEye.z, scale.y * level) / quarter * rows, 0.0, rows);
    float low = min(floor(row), rows - 1.0);
    vec2 columns = mod(vec2(floor(column), floor(column) + 1.0), impostorSize.z);
    pictureViews = vec4(columns, low, low + 1.0);
    pictureParts = vec4(fract(column), row - low, treeState.zw);

    // The height of a point in the picture is a sine of the elevation: interpolate accordingly.
    vec2 weights = sin(quarter / rows * vec2(low + 1.0 - row, row - low)) / sin(quarter / rows);
    vec2 extent = mat2(impostorExtents[int(low)], impostorExtents[int(low) + 1]) * weights;
    float rise = mix(extent.x, extent.y, osg_Vertex.y) * length(vec2(scale.y * level, scale.x * toEye.z));
    float across = osg_Vertex.x * impostorSize.x * scale.x;

    // The plane of the picture contains the middle of the tree.
    vec3 point = across * vec3(-ahead.y, ahead.x, 0.0) + rise * up + 0.5 * height * toEye.z * toEye;
    float share = clamp(mix(rise / height, 0.75, toEye.z * toEye.z), 0.0, 1.0);
    point.xy += treeState.xy * pow(share, leanPower);
    vec2 lean = treeState.xy / height; // at most 1: the stem keeps its length
    point.z *= mix(1.0, sqrt(max(1.0 - dot(lean, lean), 0.0)), share);

    vec4 eyePosition = osg_ModelViewMatrix * vec4(treePlace.xyz + down * point, 1.0);
    pictureCoord = mix(vec2(margin), vec2(1.0 - margin), vec2(0.5 + 0.5 * osg_Vertex.x, osg_Vertex.y));
    pictureEye = eyePosition.xyz;
    pictureLeft = mix(treeLight.x, treeLight.y, smoothstep(0.25, 1.0, clamp(rise / height, 0.0, 1.0) + toEye.z * toEye.z));
    vec4 middle = osg_ModelViewMatrix * vec4(treePlace.xyz + 0.5 * height * down[2], 1.0);
    vec3 sunScattering, sunWay;
    linearLight(middle.xyz, barkLight, leafLightMore, lightByNormal, sunScattering, sunWay);
    vec2 turn = vec2(cos(treePlace.w), sin(treePlace.w));
    mat3 heading = mat3(turn.x, turn.y, 0.0, -turn.y, turn.x, 0.0, 0.0, 0.0, 1.0);
    mat3 fromTree = mat3(normalize(osg_NormalMatrix[0]), normalize(osg_NormalMatrix[1]), normalize(osg_NormalMatrix[2])) * down;
    lightByNormal = lightByNormal * fromTree * heading;
    vec3 tint = treeTint(treeState.w);
    barkLight *= tint;
    leafLightMore *= tint;
    for (int i = 0; i < 3; ++i)
        lightByNormal[i] *= tint;
    sunLight *= tint;
#ifdef SHADOWED
    pictureSunScattering = sunScattering;
    pictureSunWay = sunWay * (fromTree * heading);
    float depth = 0.5 * mix(impostorSize.x * scale.x, height, toEye.z * toEye.z);
    pictureFront = pictureEye + depth * normalize(osg_NormalMatrix * (down * toEye));
#endif
    placeSurface(eyePosition, normalize(osg_NormalMatrix * (down * toEye)), treeState.w);
}
