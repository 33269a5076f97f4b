#version 330 compatibility
// SPDX-License-Identifier: MIT
// Bark of trees in an instanced draw. Vertices are at a distance `radius` from the centre line of the branch.
// gl_Vertex: centre, radius; gl_Normal: outward; gl_MultiTexCoord0: u (0 to 2 around), v, unit and reach
// (instance.glsl); gl_MultiTexCoord1: shade (law/shade.glsl).

#pragma import_defines(FADING)

#include "real.glsl"
#include "law/limits.glsl"
#include "law/flutter.glsl"
#include "law/shoot.glsl"
#include "instance.glsl"
#include "light.glsl"
#define VERTEX_SHADER
#include "surface.glsl"

uniform vec3 flutterPhases;
uniform float limberness; // species.leaf.shoot_sway

out vec3 barkCoord; // bark_texture.glsl
out float barkRadius; // metres
out vec3 barkLight;
out vec3 scenePosition;

void main() {
#ifdef FADING
    if (isLeftOut(0.5)) {
        gl_Position = leftOut;
        return;
    }
#endif
    UnitPose pose = unitPose(int(gl_MultiTexCoord0.z));
    vec3 rest = treeSize.xxy * gl_Vertex.xyz;
    float reach = reachOf(gl_MultiTexCoord0.z);
    if (reach > 0.0)
        rest += limberness * shootSway(rest, reach, pose.wind, flutterPhases, treeState.z);
    rest += treeSize.z * gl_Vertex.w * gl_Normal;
    vec4 eyePosition = eyePoint(pose, rest);
    Shade shade = Shade(unpackedShares(gl_MultiTexCoord1.x), unpackedShares(gl_MultiTexCoord1.y), treeHeading(),
                        leftByNeighbours(rest.z));
    vec3 eyeNormal = eyeDirection(pose, gl_Normal);
    barkLight = barkShade(eyePosition.xyz, eyeNormal, shade);
    barkCoord = vec3(gl_MultiTexCoord0.xy, gl_MultiTexCoord0.x - 2.0 * step(1.0, gl_MultiTexCoord0.x));
    barkRadius = treeSize.z * gl_Vertex.w;
    treeFade = treeState.y;
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeState.z);
}
