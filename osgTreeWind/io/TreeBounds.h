// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <set>
#include <vector>

namespace osgTreeWind {

/// Number, bounds and growing spaces of all trees, of a document or world.
struct TreeBounds {
    std::size_t count = 0, named = 0;
    glm::dvec3 low{0.0}, high{0.0};         ///< Bounds of the positions.
    std::set<std::size_t> inForest, inOpen; ///< Species with trees in stands, and with open-grown trees.

    void add(const TreePlacement& tree);
    void add(const std::vector<TreePlacement>& trees);
    /// Appends the names of the species to ForestTiles::inForest and inOpen.
    void addSpeciesNames(const std::vector<Species>& species, ForestTiles& tiles) const;
};

} // namespace osgTreeWind
