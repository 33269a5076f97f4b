// SPDX-License-Identifier: MIT
// Bark of trees in an instanced draw. Vertices are at a distance `radius` from the centre line of the branch.

#pragma import_defines(FADING, HOST_ARRAYS, TIERS_COLORED)

#include "real.glsl"
#include "law/limits.glsl"
#include "law/flutter.glsl"
#include "law/shoot.glsl"
#include "instance.glsl"
#include "bark_vertex.glsl"
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
    BarkVertex bark = barkVertex();
    UnitPose pose = unitPose(int(bark.unit));
    vec3 rest = treeSize.xxy * bark.centre;
    float radius = treeSize.z * bark.radius;
    float reach = reachOf(bark.unit);
    if (reach > 0.0)
        rest += limberness * shootSway(rest, reach, pose.wind, flutterPhases, treeState.z);
    rest += radius * bark.outward;
    vec4 eyePosition = eyePoint(pose, rest);
    Shade shade = Shade(sharesInSeason(unpackedShares(bark.shade.x), treeState.w),
                        sharesInSeason(unpackedShares(bark.shade.y), treeState.w), treeHeading(),
                        leftByNeighbours(rest.z));
    vec3 eyeNormal = eyeDirection(pose, bark.outward);
    // Wood thinner than a pixel is drawn as wide as that, and covers a share of it (Persson 2012, phone-wire AA).
    float w = dot(vec4(osg_ProjectionMatrix[0][3], osg_ProjectionMatrix[1][3], osg_ProjectionMatrix[2][3],
                       osg_ProjectionMatrix[3][3]), eyePosition);
    float wide = max(radius, w / (osg_ProjectionMatrix[1][1] * viewportHeight));
    eyePosition.xyz += (wide - radius) * eyeNormal;
    barkCover = radius / wide;
    barkLight = barkShade(eyePosition.xyz, eyeNormal, shade);
    barkCoord = vec3(bark.coord, bark.coord.x - 2.0 * step(1.0, bark.coord.x));
    barkGirth = vec2(radius, treeSize.y * bark.centre.z);
    passTree();
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeState.z);
}
