// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Flow in an unbounded stand by height, from the ground to the canopy top, at equal distances.
struct StandFlow {
    float friction = 0.0f;         ///< u* over the mean wind at the top.
    float displacement = 0.0f;     ///< Over the height of the stand.
    std::vector<float> mean;       ///< Mean wind over that at the top; at the ground, that just above it.
    std::vector<float> stress;     ///< Shear stress over that at the top, u*^2.
    std::vector<float> turbulence; ///< Standard deviation of the wind over that at the top.
};

/// The flow in a stand with any distribution of leaves: the second-order closure of Wilson and Shaw 1977,
/// with the mixing length of Katul et al. 2004. @param drag force over the squared mean wind, per ground
/// area, in equal layers from the ground up, at least one; negative and NaN count as 0. @param steps levels
/// per layer.
StandFlow solveStandFlow(const std::vector<float>& drag, std::size_t steps = 1);

} // namespace osgTreeWind
