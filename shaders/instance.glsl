// SPDX-License-Identifier: MIT
// Place, size and unit poses (unit_poses.frag) of a tree in an instanced draw.

#include "data.glsl"
#include "law/rotation.glsl"

in vec4 treePlace; // foot; tangent of half the heading
in vec4 treeSize;  // scales of lengths across and upward, of radii, of leaf clusters
in vec4 treeState; // first block of its poses (PosePage), fade (dither.glsl, isLeftOut()), number of the tree, share of leaves
in vec4 treeLight; // share of light that neighbours leave at the foot and at the top; inverse height; tier + brightness / 8

uniform sampler2D poseRotations;    // quaternions
uniform sampler2D poseTranslations; // metres; wind speed at the unit, m/s
uniform sampler2D posePulls;        // foliagePull() on the unit's leaves, in its rest axes

flat out float treeFade;
#ifdef TIERS_COLORED
flat out vec3 treeTierColor; // tierColor() in osgTreeWind/drawing/instanced/TreeTiers.h
#endif

int treeTier() { return int(treeLight.w); } // Tier in osgTreeWind/drawing/instanced/TreeTiers.h

/// Passes what the fragments of a tree share.
void passTree() {
    treeFade = treeState.y;
#ifdef TIERS_COLORED
    float coarse = float(treeTier()) / 5.0;
    treeTierColor = coarse == 0.0 ? vec3(1.0, 0.05, 0.05) : vec3(1.0 - coarse, 0.8, 0.05);
#endif
}

/// Brightness of the leaves, which gives each tier that of the full tree.
float leafBrightness() { return 8.0 * fract(treeLight.w); }

/// Whether a part of the tree is omitted during a transition between levels of detail. A fade above 1 is 1 plus the
/// share of parts to draw; a fade below -1 draws the complement of the parts of -fade.
/// @param chance uniform over the parts, in [0, 1).
bool isLeftOut(float chance) {
    return treeState.y > 1.0 ? chance >= treeState.y - 1.0 : treeState.y < -1.0 && chance < -treeState.y - 1.0;
}
/// Position of all corners of an omitted part, so that nothing is drawn.
const vec4 leftOut = vec4(0.0, 0.0, 0.0, 1.0);

/// Share of the light that neighbours leave at a place. @param height above the foot at rest, metres.
float leftByNeighbours(float height) {
    return mix(treeLight.x, treeLight.y, smoothstep(0.25, 1.0, height * treeLight.z));
}

struct UnitPose {
    vec4 rotation;
    vec3 translation;
    float wind;
};

/// Distance of a vertex from thick wood along thin wood at rest, metres: the fraction of the unit's number.
float reachOf(float unit) { return 4.0 * fract(unit) * treeSize.x; }

int poseTexel(int unit) { return (int(treeState.x) << 6) + unit; }

UnitPose unitPose(int unit) {
    int texel = poseTexel(unit);
    vec4 moved = dataTexel(poseTranslations, texel);
    return UnitPose(dataTexel(poseRotations, texel), moved.xyz, moved.w);
}

/// Cosine and sine of the heading.
vec2 treeHeading() {
    float tangent = treePlace.w;
    float part = 2.0 / (1.0 + tangent * tangent);
    return vec2(part - 1.0, part * tangent);
}

/// Rotates a vector from the axes of the tree to those of the forest.
vec3 turnedByHeading(vec3 v) {
    vec2 turn = treeHeading();
    return vec3(turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y, v.z);
}

/// Eye-space position of a point that moves with a unit. @param rest in the tree's rest frame, scaled.
vec4 eyePoint(UnitPose pose, vec3 rest) {
    vec3 inTree = turnVector(pose.rotation, rest) + pose.translation;
    return osg_ModelViewMatrix * vec4(turnedByHeading(inTree) + treePlace.xyz, 1.0);
}

vec3 eyeDirection(UnitPose pose, vec3 rest) {
    return normalize(osg_NormalMatrix * turnedByHeading(turnVector(pose.rotation, rest)));
}
