// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeSize.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// A size in metres, or 0 for "not given".
float given(float size) {
    return size > 0.0f ? glm::clamp(size, 0.001f, 1000.0f) : 0.0f;
}

/// Keeps the search for a size that the shape cannot have from running away.
float near(float factor, float expected) {
    return glm::clamp(factor, 0.02f * expected, 50.0f * expected);
}

struct Extents {
    glm::vec3 low{0.0f}, high{0.0f}; // the foot of the trunk is always part of the tree

    bool mayGrowBy(const glm::vec3& centre, float reach) const {
        return glm::any(glm::lessThan(centre - reach, low)) ||
               glm::any(glm::greaterThan(centre + reach, high));
    }
    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

Extents extentsOf(const TreeModel& model, const TreeScale& scale) {
    Extents extents;
    for (const SkinVertex& vertex : model.skin.vertices)
        extents.add(scale.axes * vertex.centre + scale.radius * vertex.radius * vertex.outward);
    float reach = 0.0f;
    for (const LeafVertex& vertex : model.leafMesh)
        reach = std::max(reach, glm::length(vertex.corner));
    for (const LeafCluster& leaf : model.leaves) {
        const glm::vec3 anchor = scale.axes * leaf.anchor;
        const float size = scale.leaf * leaf.size;
        if (!extents.mayGrowBy(anchor, reach * size))
            continue;
        for (const LeafVertex& vertex : model.leafMesh)
            extents.add(anchor + leaf.orientation * (size * vertex.corner));
    }
    return extents;
}

float trunkRadiusAt(const Skeleton& skeleton, const TreeScale& scale, float height) {
    float radius = skeleton.units.front().baseRadius;
    for (const BranchUnit& unit : skeleton.units) {
        const float base = scale.axes.z * unit.base.z, tip = scale.axes.z * unit.tip.z;
        if (unit.level == 0 && height >= base)
            radius =
                glm::mix(unit.baseRadius, unit.tipRadius, std::min((height - base) / (tip - base), 1.0f));
    }
    return scale.radius * radius;
}

} // namespace

TreeSize measureTree(const TreeModel& model, const TreeScale& scale) {
    const Extents extents = extentsOf(model, scale);
    TreeSize size;
    size.height = extents.high.z;
    size.trunkDiameter = 2.0f * trunkRadiusAt(model.skeleton, scale, std::min(1.3f, 0.1f * size.height));
    size.crownWidth = 0.5f * (extents.high.x - extents.low.x + extents.high.y - extents.low.y);
    return size;
}

TreeScale fitTree(const TreeModel& model, const TreeSize& size) {
    const TreeSize rest = measureTree(model);
    const float height = given(size.height), trunk = given(size.trunkDiameter),
                crown = given(size.crownWidth);
    TreeScale scale;
    for (int round = 0; round < 24; ++round) {
        const TreeSize now = measureTree(model, scale);
        const float up = height > 0.0f ? height / now.height : 1.0f;
        const float out = crown > 0.0f ? crown / now.crownWidth : 1.0f;
        const float thick = trunk > 0.0f ? trunk / now.trunkDiameter : 1.0f;
        scale.axes.z = near(scale.axes.z * up, height > 0.0f ? height / rest.height : 1.0f);
        scale.axes.x = crown > 0.0f ? near(scale.axes.x * out, crown / rest.crownWidth) : scale.axes.z;
        scale.axes.y = scale.axes.x;
        scale.radius = trunk > 0.0f ? scale.radius * thick : scale.axes.z;
        scale.leaf = std::cbrt(scale.axes.x * scale.axes.y * scale.axes.z);
        if (std::max({std::abs(up - 1.0f), std::abs(out - 1.0f), std::abs(thick - 1.0f)}) < 0.003f)
            break;
    }
    return scale;
}

} // namespace osgTreeWind
