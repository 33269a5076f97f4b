// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// The size that a tree grows to. Metres.
struct GrowthGoal {
    float height = 15.0f;       ///< Of its highest shoot, 1 to 100.
    float trunkDiameter = 0.4f; ///< At breast height (1.3 m, or a tenth of a height below 13 m), 0.01 to 5.
    float crownWidth = 8.0f;    ///< Twice the mean reach of its living shoots in eight directions, 0.2 to 60.
};

} // namespace osgTreeWind
