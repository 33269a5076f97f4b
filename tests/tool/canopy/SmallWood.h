// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/CanopyRows.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace osgTreeWind {

inline TreePlacement treeAt(const glm::dvec3& position, std::size_t species = 0, float height = 0.0f) {
    TreePlacement tree;
    tree.species = species;
    tree.position = position;
    tree.size.height = height;
    return tree;
}

/// An oak, a birch, a spruce and a palm of different sizes, far from the world's zero.
inline ForestDescription smallWood() {
    ForestDescription forest;
    for (const char* name : {"oak", "silver birch", "Norway spruce", "palm"})
        forest.species.push_back(*findSpecies(name));
    forest.origin = {567890.0, 5934560.0, 20.0};
    for (std::size_t i = 0; i < forest.species.size(); ++i) {
        const auto at = static_cast<double>(i);
        forest.trees.push_back(treeAt(forest.origin + glm::dvec3(9.3 * at, 4.1 * at, 1.7 * at), i,
                                      9.0f + 3.0f * static_cast<float>(i)));
        forest.trees.back().heading = 0.7f * static_cast<float>(i);
    }
    return forest;
}

/// All rows of a canopy in memory.
struct WholeCanopy {
    CanopyGrid grid;
    CanopyTally tally;
    std::vector<float> leaf, drag;

    WholeCanopy(const PlacedForest& forest, const CanopyGrid& over) : grid(over) {
        tally = spreadCanopy(forest, grid, [&](const CanopyRow& row) {
            EXPECT_EQ(leaf.size(), static_cast<std::size_t>(row.row) * row.leaf.size);
            leaf.insert(leaf.end(), row.leaf.begin(), row.leaf.end());
            drag.insert(drag.end(), row.drag.begin(), row.drag.end());
            return true;
        });
    }

    float at(const std::vector<float>& field, int x, int y, int z) const {
        return field[static_cast<std::size_t>((y * grid.cells.z + z) * grid.cells.x + x)];
    }
    /// Sum of a field over the grid, m^2.
    double sum(const std::vector<float>& field) const {
        double sum = 0.0;
        for (const float density : field)
            sum += static_cast<double>(density) * grid.volume();
        return sum;
    }
    /// Centre of a field.
    glm::dvec3 middle(const std::vector<float>& field) const {
        glm::dvec3 moment(0.0);
        for (int y = 0; y < grid.cells.y; ++y)
            for (int z = 0; z < grid.cells.z; ++z)
                for (int x = 0; x < grid.cells.x; ++x)
                    moment += static_cast<double>(at(field, x, y, z)) * grid.volume() *
                              (grid.low + grid.cell * (glm::dvec3(x, y, z) + 0.5));
        return moment / sum(field);
    }
};

inline CanopyGrid gridOver(const PlacedForest& forest, const glm::dvec3& cell, bool aboveGround = false,
                           const std::optional<CanopyBounds>& bounds = {}) {
    const Result<CanopyGrid> grid = canopyGridOver(forest, cell, aboveGround, bounds);
    EXPECT_TRUE(grid) << grid.problems().front().text();
    return grid.value();
}

} // namespace osgTreeWind
