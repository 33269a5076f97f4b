// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/TreeTiers.h>

#include <array>
#include <cstddef>
#include <numeric>

namespace osgTreeWind {

/// How many trees are drawn in which way. One that fades from one tier to the next counts in both.
struct DrawnTrees {
    std::size_t full = 0; ///< With all leaves, whatever their bark.
    std::size_t byBoughs = 0, asPictures = 0;

    /// @param listed InstancedTrees::listedTrees()
    explicit DrawnTrees(const std::array<std::size_t, tierCount>& listed) {
        const auto boughs = listed.begin() + leafTiers, pictures = listed.begin() + branchTiers;
        full = std::accumulate(listed.begin(), boughs, std::size_t(0));
        byBoughs = std::accumulate(boughs, pictures, std::size_t(0));
        asPictures = std::accumulate(pictures, listed.end(), std::size_t(0));
    }
};

} // namespace osgTreeWind
