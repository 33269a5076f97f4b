#version 330 compatibility
// SPDX-License-Identifier: MIT
// The pose pass: where a unit stands, from its own turn and those of the units that carry it.

#include "data.glsl"
#include "pose_request.glsl"
#include "law/rotation.glsl"

uniform sampler2D unitTurns;  // quaternions
uniform sampler2D unitSpeeds; // of the wind

void main() {
    ivec2 at = treeAndUnit();
    if (at.y >= unitCount)
        discard;
    vec3 axes = axesOf(at.x);
    vec4 rotation = vec4(0.0, 0.0, 0.0, 1.0);
    vec3 translation = vec3(0.0);
    for (int unit = at.y; unit >= 0;) {
        vec4 turn = texelFetch(unitTurns, texelOfUnit(at.x, unit), 0);
        vec4 rest = dataTexel(treeUnits, 2 * unit);
        vec3 base = axes * rest.xyz;
        rotation = turnAfter(turn, rotation);
        translation = turnVector(turn, translation - base) + base;
        unit = int(rest.w);
    }
    gl_FragData[0] = rotation;
    gl_FragData[1] = vec4(translation, texelFetch(unitSpeeds, texelOfUnit(at.x, at.y), 0).x);
}
