// SPDX-License-Identifier: MIT
// Bark of trees in an instanced draw. Vertices are at a distance `radius` from the centre line of the branch.
// osg_Vertex: centre, radius; osg_Normal: outward; osg_MultiTexCoord0: u (0 to 2 around), v, unit and reach
// (instance.glsl); osg_MultiTexCoord1: shade (law/shade.glsl).

#pragma import_defines(FADING, TIERS_COLORED)

#include "real.glsl"
#include "law/limits.glsl"
#include "law/flutter.glsl"
#include "law/shoot.glsl"
#include "instance.glsl"
#include "light.glsl"
#include "surface.glsl"

uniform vec3 flutterPhases;
uniform float limberness; // species.leaf.shoot_sway
uniform float viewportHeight; // pixels

out vec3 barkCoord; // bark_texture.glsl
out vec2 barkGirth; // radius of the wood and its height above the ground, m
out float barkCover; // share of its pixels that thin wood covers
out vec3 barkLight;
out vec3 scenePosition;

void main() {
#ifdef FADING
    if (isLeftOut(0.5)) {
        gl_Position = leftOut;
        return;
    }
#endif
    UnitPose pose = unitPose(int(osg_MultiTexCoord0.z));
    vec3 rest = treeSize.xxy * osg_Vertex.xyz;
    float reach = reachOf(osg_MultiTexCoord0.z);
    if (reach > 0.0)
        rest += limberness * shootSway(rest, reach, pose.wind, flutterPhases, treeState.z);
    rest += treeSize.z * osg_Vertex.w * osg_Normal;
    vec4 eyePosition = eyePoint(pose, rest);
    Shade shade = Shade(sharesInSeason(unpackedShares(osg_MultiTexCoord1.x), treeState.w),
                        sharesInSeason(unpackedShares(osg_MultiTexCoord1.y), treeState.w), treeHeading(),
                        leftByNeighbours(rest.z));
    vec3 eyeNormal = eyeDirection(pose, osg_Normal);
    // Wood thinner than a pixel is drawn as wide as that, and covers a share of it (Persson 2012, phone-wire AA).
    float radius = treeSize.z * osg_Vertex.w;
    float w = dot(vec4(osg_ProjectionMatrix[0][3], osg_ProjectionMatrix[1][3], osg_ProjectionMatrix[2][3],
                       osg_ProjectionMatrix[3][3]), eyePosition);
    float wide = max(radius, w / (osg_ProjectionMatrix[1][1] * viewportHeight));
    eyePosition.xyz += (wide - radius) * eyeNormal;
    barkCover = radius / wide;
    barkLight = barkShade(eyePosition.xyz, eyeNormal, shade);
    barkCoord = vec3(osg_MultiTexCoord0.xy, osg_MultiTexCoord0.x - 2.0 * step(1.0, osg_MultiTexCoord0.x));
    barkGirth = vec2(radius, treeSize.y * osg_Vertex.z);
    passTree();
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeState.z);
}
