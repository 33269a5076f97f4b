// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <optional>

namespace osgTreeWind {

/// How a tree sways freely.
struct FreeSway {
    double frequency = 0.0;    ///< Of the top of the trunk, Hz.
    double dampingRatio = 0.0; ///< Of the mode that moves it most, from its decrement; 1 is critical.
};

/// Pulls one tree sideways at the top of its trunk, lets go in a calm and follows the top until six
/// half-swings have passed (law `modal`, with modes of the tree's own).
/// @param tree its size, seed, leaves and room; species and place do not count. @param pull over the length
/// of the trunk, > 0: the further, the more the air damps. A twentieth is what a fresh wind does.
/// @return nothing when it does not swing: critically damped, or six half-swings take more than ten minutes.
std::optional<FreeSway> pullAndRelease(const Species& species, const TreePlacement& tree, double pull = 0.05);

} // namespace osgTreeWind
