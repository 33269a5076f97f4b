// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeExtents.h>

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>

#include <glm/common.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace osgTreeWind {
namespace {

bool turnsRight(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) < (b.y - a.y) * (c.x - a.x);
}

/// Removes most points that are not the highest so far in the order of outerHull(), so that few are sorted.
void removeHidden(TreeExtents::Hull& points) {
    constexpr int levels = 32;
    float high = 0.0f;
    for (const glm::vec2& point : points)
        high = std::max(high, point.y);
    const auto levelOf = [&](float y) { // of the last height that y reaches
        return y > 0.0f && high > 0.0f ? std::min(static_cast<int>(y / high * levels), levels - 1) : 0;
    };
    std::array<float, levels + 1> farthest{}; // largest x of the points at or above the next level
    farthest.fill(std::numeric_limits<float>::lowest());
    for (const glm::vec2& point : points) {
        float& x = farthest[static_cast<std::size_t>(levelOf(point.y))];
        x = std::max(x, point.x);
    }
    for (std::size_t level = levels; level-- > 0;)
        farthest[level] = std::max(farthest[level], farthest[level + 1]);
    points.erase(std::remove_if(points.begin(), points.end(),
                                [&](const glm::vec2& point) {
                                    return point.x < farthest[static_cast<std::size_t>(levelOf(point.y)) + 1];
                                }),
                 points.end());
}

/// Corners of the convex hull on the side of positive x and y, from the largest `along` on.
TreeExtents::Hull outerHull(TreeExtents::Hull points) {
    removeHidden(points);
    std::sort(points.begin(), points.end(),
              [](const glm::vec2& a, const glm::vec2& b) { return a.x != b.x ? a.x > b.x : a.y > b.y; });
    TreeExtents::Hull hull;
    for (const glm::vec2& point : points) {
        if (!hull.empty() && point.y <= hull.back().y)
            continue;
        while (hull.size() > 1 && !turnsRight(point, hull.back(), hull[hull.size() - 2]))
            hull.pop_back();
        hull.push_back(point);
    }
    return hull;
}

float farthestReach(const TreeExtents::Hull& hull, float axis, float factor) {
    float reach = 0.0f;
    for (const glm::vec2& corner : hull)
        reach = std::max(reach, axis * corner.x + factor * corner.y);
    return reach;
}

/// Merges successive points with the same `along`, such as the vertices of a ring.
void add(TreeExtents::Hull& points, float along, float beyond) {
    if (!points.empty() && points.back().x == along)
        points.back().y = std::max(points.back().y, beyond);
    else
        points.emplace_back(along, beyond);
}

void add(std::array<TreeExtents::Hull, 5>& sides, const glm::vec3& along, const glm::vec3& beyond) {
    for (int axis = 0; axis < 3; ++axis)
        add(sides[static_cast<std::size_t>(2 * axis)], along[axis], beyond[axis]);
    add(sides[1], -along.x, -beyond.x);
    add(sides[3], -along.y, -beyond.y);
}

} // namespace

std::array<float, 5> TreeExtents::reach(const TreeScale& scale) const {
    std::array<float, 5> reach{};
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const float axis = scale.axes[static_cast<int>(side / 2)];
        reach[side] = std::max(farthestReach(sides[side].wood, axis, scale.radius),
                               farthestReach(sides[side].leaves, axis, scale.leaf));
    }
    return reach;
}

float TreeExtents::trunkRadius(const TreeScale& scale, float height) const {
    float radius = trunk.empty() ? 0.0f : trunk.front().baseRadius;
    for (const BranchUnit& unit : trunk) {
        const float base = scale.axes.z * unit.base.z, tip = scale.axes.z * unit.tip.z;
        if (height >= base)
            radius =
                glm::mix(unit.baseRadius, unit.tipRadius, std::min((height - base) / (tip - base), 1.0f));
    }
    return scale.radius * radius;
}

TreeExtents makeTreeExtents(const TreeModel& model) {
    std::array<TreeExtents::Hull, 5> wood, leaves;
    Skeleton open = model.skeleton; // flare and collars do not make a tree wider
    open.joined = false;
    const BranchSkin tubes = makeBranchSkin(open);
    for (const SkinVertex& vertex : tubes.vertices)
        add(wood, vertex.centre, vertex.radius * vertex.outward);
    for (const LeafCluster& leaf : model.leaves)
        for (const LeafVertex& vertex : model.leafMesh)
            add(leaves, leaf.anchor, leaf.orientation * (leaf.size * vertex.corner));
    TreeExtents extents;
    for (std::size_t side = 0; side < extents.sides.size(); ++side)
        extents.sides[side] = {outerHull(std::move(wood[side])), outerHull(std::move(leaves[side]))};
    std::copy_if(model.skeleton.units.begin(), model.skeleton.units.end(), std::back_inserter(extents.trunk),
                 [](const BranchUnit& unit) { return unit.level == 0; });
    return extents;
}

} // namespace osgTreeWind
