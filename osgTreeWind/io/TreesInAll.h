// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <set>
#include <vector>

namespace osgTreeWind {

/// What has to be known of all trees before a part of them can be taken for itself.
struct TreesInAll {
    std::size_t count = 0, named = 0;
    glm::dvec3 low{0.0}, high{0.0};         ///< Of their places.
    std::set<std::size_t> inForest, inOpen; ///< Species of which trees stand there.

    void add(const std::vector<TreePlacement>& trees);
    /// Says to tiles how the species of a forest stand, beside what they know.
    void nameCompanies(const std::vector<Species>& species, ForestTiles& tiles) const;
};

} // namespace osgTreeWind
