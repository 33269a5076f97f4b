#version 330 compatibility
// SPDX-License-Identifier: MIT
// Bark: vertices are at a distance `radius` from the centre line of the branch.
// gl_Vertex: centre, radius; gl_Normal: outward; gl_MultiTexCoord0: u (0 to 2 around), v, unit;
// gl_MultiTexCoord1: shade (law/shade.glsl).

#include "branchwise/tree.glsl"
#include "light.glsl"
#define VERTEX_SHADER
#include "surface.glsl"

uniform float treeOwn; // number of the tree, [0, 1)

out vec3 barkCoord; // bark_texture.glsl
out float barkRadius; // metres
out vec3 barkLight;
out vec3 scenePosition;

void main() {
    UnitPose pose = unitPose(int(gl_MultiTexCoord0.z));
    vec3 rest = treeAxes * gl_Vertex.xyz + treeSizes.x * gl_Vertex.w * gl_Normal;
    vec4 eyePosition = gl_ModelViewMatrix * vec4(turnVector(pose.rotation, rest) + pose.translation, 1.0);
    vec3 eyeNormal = normalize(gl_NormalMatrix * turnVector(pose.rotation, gl_Normal));

    Shade shade = Shade(unpackedShares(gl_MultiTexCoord1.x), unpackedShares(gl_MultiTexCoord1.y), vec2(1.0, 0.0), 1.0);
    barkLight = barkShade(eyePosition.xyz, eyeNormal, shade);
    barkCoord = vec3(gl_MultiTexCoord0.xy, gl_MultiTexCoord0.x - 2.0 * step(1.0, gl_MultiTexCoord0.x));
    barkRadius = treeSizes.x * gl_Vertex.w;
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeOwn);
}
