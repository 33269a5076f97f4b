// SPDX-License-Identifier: MIT
// Unit poses and scales of a tree, for its vertex shaders.

#include "data.glsl"
#include "law/rotation.glsl"

uniform sampler2D unitPoses; // two texels per unit: rotation (quaternion x, y, z, w), translation
uniform int treeFirstUnit;   // first unit of the tree in unitPoses; negative: units at rest
uniform vec3 treeAxes;       // scale of centre lines
uniform vec2 treeSizes;      // scale of radii, of leaf clusters

struct UnitPose {
    vec4 rotation;
    vec3 translation;
};

UnitPose unitPose(int unit) {
    if (treeFirstUnit < 0)
        return UnitPose(vec4(0.0, 0.0, 0.0, 1.0), vec3(0.0));
    int texel = 2 * (treeFirstUnit + unit);
    return UnitPose(dataTexel(unitPoses, texel), dataTexel(unitPoses, texel + 1).xyz);
}
