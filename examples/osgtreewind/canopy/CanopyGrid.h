// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace osgTreeWind {

/// Rectangle on the map, world coordinates, metres.
struct CanopyBounds {
    glm::dvec2 low{0.0}, high{0.0};
};

/// Box around the wood and leaves of a tree at rest, from its foot up; world coordinates, metres.
struct TreeBox {
    glm::dvec3 low{0.0}, high{0.0};
};

TreeBox treeBox(const PlacedForest& forest, const PlacedTree& tree);

/// Grid of cells over a forest, along the axes of the world; metres.
struct CanopyGrid {
    /// True: heights count from the ground below the middle of each column of cells, or from the foot of each
    /// tree where there is no ground. False: heights of the world.
    bool aboveGround = false;
    glm::dvec3 low{0.0};
    glm::dvec3 cell{1.0};
    glm::ivec3 cells{0};

    static constexpr double mostCells = 4e9;

    double volume() const { return cell.x * cell.y * cell.z; } ///< Volume of a cell, m^3.
    glm::dvec3 high() const { return low + cell * glm::dvec3(cells); }
    /// Index of the cell that holds a coordinate along an axis; may be outside the grid.
    std::int64_t index(int axis, double coordinate) const;
    /// Height of the ground in a column, or `fallback` where there is no ground.
    double groundHeight(int column, int row, const Ground* ground, double fallback) const;
};

/// The columns of a grid that a tree may reach.
struct CanopyFootprint {
    glm::ivec2 first{0}, last{-1}; ///< Column and row, both inclusive.
    double foot = 0.0;             ///< Height of the tree's foot in the world.

    CanopyFootprint(const CanopyGrid& grid, const TreeBox& box);

    bool isEmpty() const { return first.x > last.x || first.y > last.y; }
    /// Lowest ground in these columns, world; the foot of the tree where there is no ground.
    double lowestGround(const CanopyGrid& grid, const Ground* ground) const;
};

/// Makes a grid over all trees at rest, with its corner a whole number of cells from the zero of the world,
/// or over `bounds`. It is as high as the trees in it.
/// @param cell above 0. @return a problem with the key "cell" or "bounds" if the grid would have no cells or
/// more than mostCells, or if a side of the bounds is not a whole number of cells.
Result<CanopyGrid> canopyGridOver(const PlacedForest& forest, const glm::dvec3& cell, bool aboveGround,
                                  const std::optional<CanopyBounds>& bounds = {});

} // namespace osgTreeWind
