// SPDX-License-Identifier: MIT
// A corner of a leaf card in an instanced draw, rotated by flutter, rest orientation, wind and branch.

#pragma import_defines(FADING, HOST_ARRAYS, TIERS_COLORED)

#include "real.glsl"
#include "law/limits.glsl"
#include "law/elementary.glsl"
#include "law/oscillator.glsl"
#include "law/flutter.glsl"
#include "law/shoot.glsl"
#include "law/tint.glsl"
#include "facing.glsl"
#include "instance.glsl"
#include "leaf_corner.glsl"
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
    LeafCorner leaf = leafCorner();
#ifdef FADING
    if (isLeftOut(fract(0.7548777 * leaf.leaf))) {
        gl_Position = leftOut;
        return;
    }
#endif
    int unit = int(leaf.unit);
    UnitPose pose = unitPose(unit);
    vec3 rest = treeSize.xxy * leaf.anchor;
    rest += limberness * shootSway(rest, reachOf(leaf.unit), pose.wind, flutterPhases, treeState.z);
    leafBorne = fract(0.618034 * leaf.leaf) < treeState.w ? 1.0 : 0.0;
    vec4 pull = mix(vec4(0.0, 0.0, 0.0, 1.0), dataTexel(posePulls, poseTexel(unit)), leafBorne);
    float gust = pullOfGusts(rest, pull.xyz, flutterPhases, treeState.z, leaf.leaf);
    vec3 flutter = leafFlutter(pose.wind, gust, flutterPhases, treeState.z, leaf.leaf, flutterLimits);
    vec4 turn = turnAfter(leaf.orientation, leafRotation(flutter.x, flutter.y, flutter.z));
    vec4 downwind = downwindTurn(turnVector(leaf.orientation, vec3(0.0, 0.0, 1.0)), gust * pull.xyz);
    float tremble = leafBorne * trembleShare(pose.wind, leafTremble.y);
    vec3 trembling = trembleWave(leaf.corner, flutterPhases, treeState.z, leaf.leaf);
    vec3 corner = turnVector(downwind, turnVector(turn, leaf.corner * vec3(pull.ww, 1.0)));
    vec4 eyePosition = eyePoint(pose, rest + treeSize.w * (leaf.size * corner + leafTremble.x * tremble * trembling));

    // Foliage is lit more like a crown than like single blades.
    vec3 blade = turnVector(downwind, turnVector(turn, leaf.normal));
    vec3 crown = leaf.outward;
    vec3 normal = crown + 0.5 * sign(dot(blade, crown)) * blade;
    Shade shade = Shade(sharesInSeason(unpackedShares(leaf.shade.x), treeState.w),
                        sharesInSeason(unpackedShares(leaf.shade.y), treeState.w), treeHeading(),
                        leftByNeighbours(rest.z));
    vec3 own = mix(vec3(1.0), treeTint(treeState.z) * clusterTint(treeState.z, leaf.leaf), leafBorne);
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
    float glint = bladeGlint(leaf.leaf,
                             eyeDirection(pose, turnVector(leaf.orientation, leaf.normal)),
                             eyeDirection(pose, blade + tremble * trembling));
    leafLight = own * (leafLight + (glint - 1.0) * sunLight);
    sunLight *= glint * own;
    leafCoord = leaf.coord;
    leafCard = leaf.card;
    passTree();
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeState.z);
}
