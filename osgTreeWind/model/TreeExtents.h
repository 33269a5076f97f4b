// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <glm/vec2.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

struct TreeModel;
struct TreeScale;

/// The vertices that can be outermost at some scale; measures a tree in a microsecond.
///
/// In the direction of one side, a vertex lies at s·along + t·beyond: `along` is the position of the centre
/// line or petiole, scaled by the axes, and `beyond` the extent of bark or leaf from there, scaled by the
/// radius or leaf factor. For any s, t > 0 the outermost one is a corner of the convex hull of (along,
/// beyond).
struct TreeExtents {
    using Hull = std::vector<glm::vec2>; ///< (along, beyond), metres.
    /// Candidates on one side.
    struct Side {
        Hull wood;   ///< Bark.
        Hull leaves; ///< Leaves.
    };
    std::array<Side, 5> sides;     ///< +x, -x, +y, -y, +z.
    std::vector<BranchUnit> trunk; ///< Units of level 0, from the ground up.

    /// Extent of the tree on each side from the foot of its trunk, metres, at least 0.
    std::array<float, 5> reach(const TreeScale& scale) const;
    /// Radius of the trunk at a height above its foot, metres.
    float trunkRadius(const TreeScale& scale, float height) const;
};

TreeExtents makeTreeExtents(const TreeModel& model);

} // namespace osgTreeWind
