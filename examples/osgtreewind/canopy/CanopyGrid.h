// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace osgTreeWind {

/// What holds places of a map, world coordinates, metres.
struct CanopyBounds {
    glm::dvec2 low{0.0}, high{0.0};
};

/// What holds all wood and leaves of a tree at rest, from its foot up; world coordinates, metres.
struct TreeBox {
    glm::dvec3 low{0.0}, high{0.0};
};

TreeBox treeBox(const PlacedForest& forest, const PlacedTree& tree);

/// Cells of air over a forest, along the axes of the world; metres.
struct CanopyGrid {
    /// Heights count from the ground below the middle of each column of cells, and where there is none from
    /// the foot of each tree. Else they are the world's.
    bool aboveGround = false;
    glm::dvec3 low{0.0};
    glm::dvec3 cell{1.0};
    glm::ivec3 cells{0};

    static constexpr double mostCells = 4e9;

    double volume() const { return cell.x * cell.y * cell.z; } ///< Of a cell, m^3.
    glm::dvec3 high() const { return low + cell * glm::dvec3(cells); }
    /// The row or column or level that a coordinate is in, which may be none of the grid.
    std::int64_t index(int axis, double coordinate) const;
    /// Of a column: its ground, or where there is none `otherwise`.
    double groundOf(int column, int row, const Ground* ground, double otherwise) const;
};

/// The columns of a grid that a tree may reach.
struct CanopyFootprint {
    glm::ivec2 first{0}, last{-1}; ///< Column and row; both belong to it.
    double foot = 0.0;             ///< Of the tree, world.

    CanopyFootprint(const CanopyGrid& grid, const TreeBox& box);

    bool isEmpty() const { return first.x > last.x || first.y > last.y; }
    /// Of these columns, world; the foot where there is no ground.
    double lowestGround(const CanopyGrid& grid, const Ground* ground) const;
};

/// The grid over all trees of a forest as they stand at rest, with its corner a whole number of cells from
/// the zero of the world; or over `bounds`, as high as the trees there.
/// @param cell above 0. @return a problem of the key "cell" or "bounds" where there would be more than
/// mostCells or none, or where a side of the bounds is no whole number of cells.
Result<CanopyGrid> canopyGridOver(const PlacedForest& forest, const glm::dvec3& cell, bool aboveGround,
                                  const std::optional<CanopyBounds>& bounds = {});

} // namespace osgTreeWind
