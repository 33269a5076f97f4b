// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/MeasureTree.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// A size in metres within limits; 0: not given.
float validSize(float size) {
    return size > 0.0f ? glm::clamp(size, 0.001f, 1000.0f) : 0.0f;
}

/// Bounds a factor, so that the search for an impossible size does not diverge.
float clampNear(float factor, float expected) {
    return glm::clamp(factor, 0.02f * expected, 50.0f * expected);
}

} // namespace

TreeSize measureTree(const TreeExtents& extents, const TreeScale& scale) {
    const auto [east, west, north, south, height] = extents.reach(scale);
    TreeSize size;
    size.height = height;
    size.trunkDiameter = 2.0f * extents.trunkRadius(scale, breastHeight(height));
    size.crownWidth = 0.5f * (east + west + north + south);
    return size;
}

float trunkSection(const Skeleton& skeleton, const TreeScale& scale) {
    const float height = breastHeight(scale.axes.z * skeleton.height());
    float radius = 0.0f;
    for (const BranchUnit& unit : skeleton.units) {
        const float base = scale.axes.z * unit.base.z, tip = scale.axes.z * unit.tip.z;
        if (unit.parent < 0 || (unit.level == 0 && height >= base))
            radius = glm::mix(unit.baseRadius, unit.tipRadius,
                              std::clamp((height - base) / std::max(tip - base, 1.0e-6f), 0.0f, 1.0f));
    }
    return glm::pi<float>() * radius * radius * scale.radius * scale.radius;
}

TreeScale fitTree(const TreeExtents& extents, const TreeSize& size) {
    const TreeSize rest = measureTree(extents);
    const float height = validSize(size.height), trunk = validSize(size.trunkDiameter),
                crown = validSize(size.crownWidth);
    TreeScale scale;
    for (int round = 0; round < 24; ++round) {
        const TreeSize now = measureTree(extents, scale);
        const float up = height > 0.0f ? height / now.height : 1.0f;
        const float out = crown > 0.0f ? crown / now.crownWidth : 1.0f;
        const float thick = trunk > 0.0f ? trunk / now.trunkDiameter : 1.0f;
        scale.axes.z = clampNear(scale.axes.z * up, height > 0.0f ? height / rest.height : 1.0f);
        scale.axes.x = crown > 0.0f ? clampNear(scale.axes.x * out, crown / rest.crownWidth) : scale.axes.z;
        scale.axes.y = scale.axes.x;
        scale.radius = trunk > 0.0f ? scale.radius * thick : scale.axes.z;
        scale.leaf = math::cbrt(scale.axes.x * scale.axes.y * scale.axes.z);
        if (std::max({std::abs(up - 1.0f), std::abs(out - 1.0f), std::abs(thick - 1.0f)}) < 0.003f)
            break;
    }
    return scale;
}

TreeSize measureTree(const TreeModel& model, const TreeScale& scale) {
    return measureTree(model.extents, scale);
}

TreeScale fitTree(const TreeModel& model, const TreeSize& size) {
    return fitTree(model.extents, size);
}

} // namespace osgTreeWind
