// SPDX-License-Identifier: MIT
// A tree of an instanced draw: where it stands, how large it is, and how its units stand (unit_poses.frag).

#include "law/rotation.glsl"

in vec4 treePlace; // foot; tangent of half its heading
in vec4 treeSize;  // scale of lengths across and upward, of radii, of leaf clusters
in vec4 treeState; // row of its poses, fade (dither.glsl, isLeftOut()), its own number in [0, 1), share of its leaves
in vec4 treeLight; // what its neighbours leave of the light at its foot and at its top; one over its height

uniform sampler2D poseRotations;    // quaternions
uniform sampler2D poseTranslations; // metres; speed of the wind at the unit, m/s
uniform sampler2D posePulls;        // foliagePull() on the unit's leaves, in its rest axes
uniform int unitRows;               // of a tree, each of up to 2048 units

flat out float treeFade;

/// Whether a part of the tree gives way to another form of it, which has that part, or comes yet. Above 1 the fade is 1
/// and the share of parts that there are; below -1 there are those that a fade of -fade leaves out.
/// @param chance even over the parts, in [0, 1).
bool isLeftOut(float chance) {
    return treeState.y > 1.0 ? chance >= treeState.y - 1.0 : treeState.y < -1.0 && chance < -treeState.y - 1.0;
}
/// Where all corners of what is left out lie: nothing is drawn then.
const vec4 leftOut = vec4(0.0, 0.0, 0.0, 1.0);

/// What the neighbours leave of the light at a place. @param height over the foot at rest, metres.
float leftByNeighbours(float height) {
    return mix(treeLight.x, treeLight.y, smoothstep(0.25, 1.0, height * treeLight.z));
}

struct UnitPose {
    vec4 rotation;
    vec3 translation;
    float wind;
};

/// How far along thin wood a vertex is from thick wood at rest, metres: what follows the number of its unit.
float reachOf(float unit) { return 4.0 * fract(unit) * treeSize.x; }

ivec2 poseTexel(int unit) { return ivec2(unit & 2047, int(treeState.x) * unitRows + (unit >> 11)); }

UnitPose unitPose(int unit) {
    ivec2 texel = poseTexel(unit);
    vec4 moved = texelFetch(poseTranslations, texel, 0);
    return UnitPose(texelFetch(poseRotations, texel, 0), moved.xyz, moved.w);
}

/// Its cosine and sine.
vec2 treeHeading() {
    float tangent = treePlace.w;
    float part = 2.0 / (1.0 + tangent * tangent);
    return vec2(part - 1.0, part * tangent);
}

/// From the tree's own axes to the forest's.
vec3 turnedByHeading(vec3 v) {
    vec2 turn = treeHeading();
    return vec3(turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y, v.z);
}

/// In eye space: a point of the tree's rest frame, scaled, that moves with a unit.
vec4 eyePoint(UnitPose pose, vec3 rest) {
    vec3 inTree = turnVector(pose.rotation, rest) + pose.translation;
    return gl_ModelViewMatrix * vec4(turnedByHeading(inTree) + treePlace.xyz, 1.0);
}

vec3 eyeDirection(UnitPose pose, vec3 rest) {
    return normalize(gl_NormalMatrix * turnedByHeading(turnVector(pose.rotation, rest)));
}
