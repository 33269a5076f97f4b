// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyGrid.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Problem.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Box around all trees.
TreeBox boxOfAllTrees(const PlacedForest& forest) {
    TreeBox all{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const PlacedTree& tree : forest.trees) {
        if (!tree.alive)
            continue;
        const TreeBox box = treeBox(forest, tree);
        all.low = glm::min(all.low, box.low);
        all.high = glm::max(all.high, box.high);
    }
    return all;
}

/// Lowest and highest point of the trees that reach the columns of a grid, as the grid counts heights.
glm::dvec2 heightRange(const PlacedForest& forest, const CanopyGrid& grid) {
    double low = infinity, high = -infinity;
    for (const PlacedTree& tree : forest.trees) {
        if (!tree.alive)
            continue;
        const TreeBox box = treeBox(forest, tree);
        const CanopyFootprint footprint(grid, box);
        if (footprint.isEmpty())
            continue;
        low = std::min(low, grid.aboveGround ? 0.0 : box.low.z);
        high =
            std::max(high, grid.aboveGround
                               ? box.high.z - footprint.lowestGround(grid, forest.description().ground.get())
                               : box.high.z);
    }
    return low < high ? glm::dvec2(low, high) : glm::dvec2(0.0);
}

/// Sets corner and number of cells along an axis: whole cells counted from 0, at least one.
void setCells(CanopyGrid& grid, int axis, double low, double high) {
    const double cell = grid.cell[axis], first = std::floor(low / cell);
    grid.low[axis] = first * cell;
    grid.cells[axis] = static_cast<int>(std::min(std::max(std::ceil(high / cell) - first, 1.0), 1e9));
}

Diagnostics problemOfBounds(const CanopyBounds& bounds, const glm::dvec3& cell) {
    for (int axis = 0; axis < 2; ++axis) {
        const double cells = (bounds.high[axis] - bounds.low[axis]) / cell[axis];
        if (!(std::round(cells) >= 1.0) || !(std::abs(cells - std::round(cells)) < 1e-6 * cells))
            return {keyProblem("bounds", "expected a whole number of cells of " + numberText(cell[axis]) +
                                             " m, at least 1, between " + numberText(bounds.low[axis]) +
                                             " and " + numberText(bounds.high[axis]) + ", found " +
                                             numberText(cells))};
    }
    return {};
}

Diagnostics problemOfCount(const CanopyGrid& grid) {
    const glm::dvec3 cells(grid.cells);
    const double count = cells.x * cells.y * cells.z;
    if (count <= CanopyGrid::mostCells)
        return {};
    return {keyProblem("cell", "expected a size that makes at most " + numberText(CanopyGrid::mostCells) +
                                   " cells, found " + numberText(count))};
}

} // namespace

std::int64_t CanopyGrid::index(int axis, double coordinate) const {
    const double at = std::floor((coordinate - low[axis]) / cell[axis]);
    return static_cast<std::int64_t>(std::clamp(at, -1e15, 1e15));
}

double CanopyGrid::groundHeight(int column, int row, const Ground* ground, double fallback) const {
    if (!ground)
        return fallback;
    const glm::dvec2 middle(low.x + (column + 0.5) * cell.x, low.y + (row + 0.5) * cell.y);
    return ground->height(middle).value_or(fallback);
}

TreeBox treeBox(const PlacedForest& forest, const PlacedTree& tree) {
    const std::array<float, 5> reach = forest.modelOf(tree).extents.reach(tree.scale);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    glm::vec3 low(0.0f), high(0.0f, 0.0f, reach[4]);
    for (const float x : {reach[0], -reach[1]})
        for (const float y : {reach[2], -reach[3]}) {
            const glm::vec3 corner = rotateAboutZ({x, y, 0.0f}, sine, cosine);
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    // Margin for the rounding of floats.
    const glm::vec3 rounding =
        1e-4f * (high - low) * glm::vec3(1.0f, 1.0f, 0.0f) + glm::vec3(0, 0, 1e-4f * reach[4]);
    const glm::dvec3 foot = glm::dvec3(tree.position) + forest.description().origin;
    return {foot + glm::dvec3(low - rounding * glm::vec3(1.0f, 1.0f, 0.0f)),
            foot + glm::dvec3(high + rounding)};
}

CanopyFootprint::CanopyFootprint(const CanopyGrid& grid, const TreeBox& box) : foot(box.low.z) {
    for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t most = grid.cells[axis];
        first[axis] = static_cast<int>(std::clamp<std::int64_t>(grid.index(axis, box.low[axis]), 0, most));
        last[axis] =
            static_cast<int>(std::clamp<std::int64_t>(grid.index(axis, box.high[axis]), -1, most - 1));
    }
}

double CanopyFootprint::lowestGround(const CanopyGrid& grid, const Ground* ground) const {
    double lowest = foot;
    if (ground)
        for (int row = first.y; row <= last.y; ++row)
            for (int column = first.x; column <= last.x; ++column)
                lowest = std::min(lowest, grid.groundHeight(column, row, ground, foot));
    return lowest;
}

Result<CanopyGrid> canopyGridOver(const PlacedForest& forest, const glm::dvec3& cell, bool aboveGround,
                                  const std::optional<CanopyBounds>& bounds) {
    CanopyGrid grid;
    grid.aboveGround = aboveGround;
    grid.cell = cell;
    grid.cells.z = 1;
    if (bounds) {
        if (Diagnostics problems = problemOfBounds(*bounds, cell); !problems.empty())
            return problems;
        for (int axis = 0; axis < 2; ++axis) {
            grid.low[axis] = bounds->low[axis];
            grid.cells[axis] = static_cast<int>(
                std::min(std::round((bounds->high[axis] - bounds->low[axis]) / cell[axis]), 1e9));
        }
    } else {
        const TreeBox all = boxOfAllTrees(forest);
        if (!(all.low.x <= all.high.x))
            return keyProblem("bounds", "expected x0, y0, x1 and y1 for a forest without trees");
        setCells(grid, 0, all.low.x, all.high.x);
        setCells(grid, 1, all.low.y, all.high.y);
    }
    if (Diagnostics problems = problemOfCount(grid); !problems.empty())
        return problems;
    const glm::dvec2 heights = heightRange(forest, grid);
    setCells(grid, 2, heights.x, heights.y);
    if (Diagnostics problems = problemOfCount(grid); !problems.empty())
        return problems;
    return grid;
}

} // namespace osgTreeWind
