// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <optional>

namespace osgTreeWind {

/// Free sway of a tree.
struct FreeSway {
    double frequency = 0.0;    ///< At the top of the trunk, Hz.
    double dampingRatio = 0.0; ///< Of the dominant mode, from its logarithmic decrement; 1 is critical.
};

/// Simulates a pull-and-release test: pulls one tree sideways at the top of its trunk, releases it in calm
/// and records the top for six half-swings (law `modal`, with an archetype for this tree alone).
/// @param tree its size, seed, leaves and growing space; species and position are ignored. @param pull
/// deflection over trunk length, > 0. Damping by the air grows with it; 0.05 corresponds to a fresh wind.
/// @return empty if it is critically damped, or if six half-swings take more than ten minutes.
std::optional<FreeSway> pullAndRelease(const Species& species, const TreePlacement& tree, double pull = 0.05);

} // namespace osgTreeWind
