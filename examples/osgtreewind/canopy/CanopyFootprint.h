// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/CanopyGrid.h>
#include <examples/osgtreewind/canopy/TreeBox.h>

namespace osgTreeWind {

/// The columns of a grid that a tree may reach.
struct CanopyFootprint {
    glm::ivec2 first{0}, last{-1}; ///< Column and row; both belong to it.
    double foot = 0.0;             ///< Of the tree, world.

    CanopyFootprint(const CanopyGrid& grid, const TreeBox& box);

    bool isEmpty() const { return first.x > last.x || first.y > last.y; }
    /// Of these columns, world; the foot where there is no ground.
    double lowestGround(const CanopyGrid& grid, const Ground* ground) const;
};

} // namespace osgTreeWind
