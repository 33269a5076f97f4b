#version 330 compatibility
// SPDX-License-Identifier: MIT
// Bark of trees in an instanced draw: a vertex lies `radius` outward of a point of the branch's centre line.
// gl_Vertex: centre, radius; gl_Normal: outward; gl_MultiTexCoord0: u, v, unit;
// gl_MultiTexCoord1: shade, law/shade.glsl.

#include "instance.glsl"
#include "light.glsl"

out vec2 barkCoord;
out vec3 barkLight;
out vec3 scenePosition;

void main() {
    UnitPose pose = unitPose(int(gl_MultiTexCoord0.z + 0.5));
    vec4 eyePosition = eyePoint(pose, treeSize.xxy * gl_Vertex.xyz + treeSize.z * gl_Vertex.w * gl_Normal);
    Shade shade = Shade(unpackedShares(gl_MultiTexCoord1.x), unpackedShares(gl_MultiTexCoord1.y), treeHeading());
    barkLight = barkShade(eyePosition.xyz, eyeDirection(pose, gl_Normal), shade);
    barkCoord = gl_MultiTexCoord0.xy;
    treeFade = treeState.y;
    scenePosition = eyePosition.xyz;
    gl_ClipVertex = eyePosition;
    gl_Position = gl_ProjectionMatrix * eyePosition;
}
