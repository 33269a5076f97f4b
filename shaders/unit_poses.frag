// SPDX-License-Identifier: MIT
// The pose pass: composes the pose of a unit from its rotation and those of the units that carry it.

#include "data.glsl"
#include "pose_request.glsl"
#include "real.glsl"
#include "law/limits.glsl"
#include "law/elementary.glsl"
#include "law/oscillator.glsl"
#include "law/rotation.glsl"
#include "law/flutter.glsl"
#include "law/reconfiguration.glsl"

uniform sampler2D unitTurns; // quaternions
uniform sampler2D unitWinds; // in the tree's axes

layout(location = 0) out vec4 poseRotation;
layout(location = 1) out vec4 poseTranslation;
layout(location = 2) out vec4 posePull;

void main() {
    ivec2 at = treeAndUnit();
    ivec2 units = unitsOf(at.x);
    if (at.y >= units.y)
        discard;
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int first = (texel.y << 11) + texel.x - at.y; // of the tree in unitTurns
    vec3 axes = axesOf(at.x);
    vec4 rotation = vec4(0.0, 0.0, 0.0, 1.0);
    vec3 translation = vec3(0.0);
    for (int unit = at.y; unit >= 0;) {
        vec4 turn = dataTexel(unitTurns, first + unit);
        vec4 rest = dataTexel(treeUnits, 2 * (units.x + unit));
        vec3 base = axes * rest.xyz;
        rotation = turnAfter(turn, rotation);
        translation = turnVector(turn, translation - base) + base;
        unit = int(rest.w);
    }
    poseRotation = rotation;
    vec3 wind = texelFetch(unitWinds, texel, 0).xyz;
    poseTranslation = vec4(translation, length(wind));
    vec4 foliage = foliageOf(at.x);
    vec4 pull = foliagePull(wind, foliage.x, foliage.y, foliage.z, foliage.w);
    posePull = vec4(turnVector(vec4(-rotation.xyz, rotation.w), pull.xyz), pull.w);
}
