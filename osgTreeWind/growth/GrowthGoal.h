// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Size to which a tree grows, metres.
struct GrowthGoal {
    float height = 15.0f;       ///< Height of the highest shoot, 1 to 100.
    float trunkDiameter = 0.4f; ///< DBH (at 1.3 m, or at a tenth of a height below 13 m), 0.01 to 5.
    float crownWidth = 8.0f;    ///< Twice the mean reach of the living shoots in eight directions, 0.2 to 60.
};

} // namespace osgTreeWind
