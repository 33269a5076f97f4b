// SPDX-License-Identifier: MIT
// The angle pass of the law `modal`: computes the rotation of a unit about its base, [Phi R] (q, F').

#include "data.glsl"
#include "pose_request.glsl"
#include "real.glsl"
#include "law/limits.glsl"
#include "law/rotation.glsl"

uniform sampler2D modalMatrices; // of all archetypes; per unit: the rows of its two axes, and a texel with its patch

layout(location = 0) out vec4 unitTurn;
layout(location = 1) out vec4 unitWind;

void main() {
    ivec2 at = treeAndUnit();
    ivec2 units = unitsOf(at.x);
    if (at.y >= units.y)
        discard;
    vec3 matrix = matrixOf(at.x);
    int length = int(matrix.y);
    int texel = int(matrix.x) + at.y * (2 * length + 1);
    vec2 angles = vec2(0.0);
    for (int i = 0; i < length; ++i) {
        vec4 part = shortVector(at.x, i);
        angles += vec2(dot(dataTexel(modalMatrices, texel + i), part),
                       dot(dataTexel(modalMatrices, texel + length + i), part));
    }
    int unit = 2 * (units.x + at.y);
    vec3 span = axesOf(at.x) * (dataTexel(treeUnits, unit + 1).xyz - dataTexel(treeUnits, unit).xyz);
    vec3 direction = dot(span, span) > 0.0 ? normalize(span) : vec3(0.0, 0.0, 1.0);
    unitTurn = swungRotation(bounded(angles.x, matrix.z), bounded(angles.y, matrix.z), direction);
    for (int i = 0; i < mostFallen; ++i) {
        vec4 part = fallenPart(at.x, i);
        float angle = sqrt(dot(part.xy, part.xy));
        if (angle == 0.0 || at.y != int(part.z + 0.5))
            continue;
        vec4 turn = vec4(sin(0.5 * angle) * part.xy / angle, 0.0, cos(0.5 * angle));
        unitTurn = turnAfter(turn, unitTurn);
    }
    int patchIndex = int(dataTexel(modalMatrices, texel + 2 * length).x);
    unitWind = vec4(patchWind(at.x, patchIndex), 0.0);
}
