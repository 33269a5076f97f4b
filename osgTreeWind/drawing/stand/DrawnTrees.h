// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/stand/TreeTiers.h>

#include <array>
#include <cstddef>
#include <numeric>

namespace osgTreeWind {

/// How many trees are drawn in which way. One that fades from one tier to the next counts in both.
struct DrawnTrees {
    std::size_t full = 0, byBoughs = 0, asPictures = 0;

    /// @param listed TreeStand::listedTrees()
    explicit DrawnTrees(const std::array<std::size_t, tierCount>& listed) : full(listed.front()) {
        const auto pictures = listed.begin() + branchTiers;
        byBoughs = std::accumulate(listed.begin() + 1, pictures, std::size_t(0));
        asPictures = std::accumulate(pictures, listed.end(), std::size_t(0));
    }
};

} // namespace osgTreeWind
