// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/TreeTiers.h>

#include <array>
#include <cstddef>
#include <numeric>

namespace osgTreeWind {

/// Number of trees by the way they are drawn. A tree that fades between two tiers counts in both.
struct DrawnTrees {
    std::size_t full = 0; ///< Trees with all leaves, at any detail of their bark.
    std::size_t byBoughs = 0, asPictures = 0;

    explicit DrawnTrees(const std::array<std::size_t, tierCount>& treesByTier) {
        const auto boughs = treesByTier.begin() + leafTiers, pictures = treesByTier.begin() + branchTiers;
        full = std::accumulate(treesByTier.begin(), boughs, std::size_t(0));
        byBoughs = std::accumulate(boughs, pictures, std::size_t(0));
        asPictures = std::accumulate(pictures, treesByTier.end(), std::size_t(0));
    }
};

} // namespace osgTreeWind
