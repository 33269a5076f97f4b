// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <glm/vec2.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

struct TreeModel;
struct TreeScale;

/// The few vertices that can be outermost under some scale, for sizes in a microsecond.
///
/// On one side of the tree a vertex lies at s·along + t·beyond: where the centre line or the petiole takes
/// it, stretched by the axes, and how far bark or leaf reaches from there, stretched by the radius or leaf
/// factor. Whatever s and t above 0 are, the farthest is a corner of the convex hull of (along, beyond).
struct TreeExtents {
    using Hull = std::vector<glm::vec2>; ///< (along, beyond), metres.
    /// What may reach farthest on one side.
    struct Side {
        Hull wood;   ///< Of bark.
        Hull leaves; ///< Of leaves.
    };
    std::array<Side, 5> sides;     ///< +x, -x, +y, -y, +z.
    std::vector<BranchUnit> trunk; ///< Units of level 0, from the ground up.

    /// How far the tree reaches on each side from the foot of its trunk, at least 0.
    std::array<float, 5> reach(const TreeScale& scale) const;
    /// Of the trunk at a height above its foot; metres.
    float trunkRadius(const TreeScale& scale, float height) const;
};

TreeExtents makeTreeExtents(const TreeModel& model);

} // namespace osgTreeWind
