// SPDX-License-Identifier: MIT
// A corner of a leaf cluster in an instanced draw, rotated by flutter, rest orientation, wind and branch.
// osg_Vertex: anchor, size; osg_Normal: corner in the leaf frame; osg_MultiTexCoord0: u, v, unit and reach
// (instance.glsl), leaf; osg_MultiTexCoord1: rest orientation; osg_MultiTexCoord2: normal in the leaf frame, shade
// (law/shade.glsl);
// osg_MultiTexCoord3: outward direction in the crown, shade.

#pragma import_defines(FADING, TIERS_COLORED)

#include "real.glsl"
#include "law/limits.glsl"
#include "law/elementary.glsl"
#include "law/oscillator.glsl"
#include "law/flutter.glsl"
#include "law/shoot.glsl"
#include "law/tint.glsl"
#include "facing.glsl"
#include "instance.glsl"
#include "law/reconfiguration.glsl"
#include "light.glsl"
#include "surface.glsl"

uniform vec4 flutterLimits;
uniform vec3 flutterPhases;
uniform float limberness; // species.leaf.shoot_sway
uniform vec2 leafTremble; // leafTremble() in osgTreeWind/motion/laws/StatelessFlutter.h
uniform vec3 leafUnderside; // albedo of the underside over that of the upper side
uniform vec3 leafFresh; // shootColor() over leafColor, minus 1

out vec2 leafCoord;
out vec3 leafLight;
out vec3 scenePosition;
flat out int leafCard;
flat out float leafBorne; // 1: leaves, 0: bare twigs
out vec2 leafFacing; // facing.glsl

void main() {
#ifdef FADING
    if (isLeftOut(fract(0.7548777 * osg_MultiTexCoord0.w))) {
        gl_Position = leftOut;
        return;
    }
#endif
    int unit = int(osg_MultiTexCoord0.z);
    UnitPose pose = unitPose(unit);
    vec3 rest = treeSize.xxy * osg_Vertex.xyz;
    rest += limberness * shootSway(rest, reachOf(osg_MultiTexCoord0.z), pose.wind, flutterPhases, treeState.z);
    leafBorne = fract(0.618034 * osg_MultiTexCoord0.w) < treeState.w ? 1.0 : 0.0;
    vec4 pull = mix(vec4(0.0, 0.0, 0.0, 1.0), texelFetch(posePulls, poseTexel(unit), 0), leafBorne);
    float gust = pullOfGusts(rest, pull.xyz, flutterPhases, treeState.z, osg_MultiTexCoord0.w);
    vec3 flutter = leafFlutter(pose.wind, gust, flutterPhases, treeState.z, osg_MultiTexCoord0.w, flutterLimits);
    vec4 turn = turnAfter(osg_MultiTexCoord1, leafRotation(flutter.x, flutter.y, flutter.z));
    vec4 downwind = downwindTurn(turnVector(osg_MultiTexCoord1, vec3(0.0, 0.0, 1.0)), gust * pull.xyz);
    float tremble = leafBorne * trembleShare(pose.wind, leafTremble.y);
    vec3 trembling = trembleWave(osg_Normal, flutterPhases, treeState.z, osg_MultiTexCoord0.w);
    vec3 corner = turnVector(downwind, turnVector(turn, osg_Normal * vec3(pull.ww, 1.0)));
    vec4 eyePosition = eyePoint(pose, rest + treeSize.w * (osg_Vertex.w * corner + leafTremble.x * tremble * trembling));

    // Foliage is lit more like a crown than like single blades.
    vec3 blade = turnVector(downwind, turnVector(turn, osg_MultiTexCoord2.xyz));
    vec3 crown = osg_MultiTexCoord3.xyz;
    vec3 normal = crown + 0.5 * sign(dot(blade, crown)) * blade;
    Shade shade = Shade(sharesInSeason(unpackedShares(osg_MultiTexCoord2.w), treeState.w),
                        sharesInSeason(unpackedShares(osg_MultiTexCoord3.w), treeState.w), treeHeading(),
                        leftByNeighbours(rest.z));
    vec3 own = mix(vec3(1.0), treeTint(treeState.z) * clusterTint(treeState.z, osg_MultiTexCoord0.w), leafBorne);
    vec3 eyeNormal = eyeDirection(pose, normal);
    vec3 eyeBlade = eyeDirection(pose, blade);
    float away = dot(eyeBlade, normalize(eyePosition.xyz));
    leafFacing = facingOf(abs(away));
    bool fromBelow = away > 0.0;
    float over = max(turnedOver(pose.wind, gust), tremble * (1.0 + trembling.x));
    vec3 sides = mix(vec3(1.0), leafUnderside, fromBelow ? 1.0 : over);
    own *= mix(vec3(1.0), sides * 2.0 / (1.0 + leafUnderside), leafBorne); // leafColor is the mean of both sides
    own *= leafBrightness() * (1.0 + ((gl_VertexID & 2) != 0 ? leafFresh : -leafFresh)); // shoots: outer ends of cards
    leafLight = leafShade(eyePosition.xyz, eyeNormal, eyeBlade, shade);
    float glint = bladeGlint(osg_MultiTexCoord0.w,
                             eyeDirection(pose, turnVector(osg_MultiTexCoord1, osg_MultiTexCoord2.xyz)),
                             eyeDirection(pose, blade + tremble * trembling));
    leafLight = own * (leafLight + (glint - 1.0) * sunLight);
    sunLight *= glint * own;
    leafCoord = osg_MultiTexCoord0.xy;
    leafCard = gl_VertexID / 4;
    passTree();
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeState.z);
}
