// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Numbers by which the looks of a species compare with measurements of trees.
struct TreeLooks {
    /// Share of the sky that shows within the crown's outline, from 25 degrees below its middle; in winter
    /// through twigs and branches alone, within their outline. Compare Wilkinson 1992.
    float skyThroughCrownSummer = 0.0f, skyThroughCrownWinter = 0.0f;
    float crownOverStem = 0.0f;   ///< Width of the crown over the diameter of the stem at breast height.
    float leafInclination = 0.0f; ///< Mean over the area of leaves, degrees from the horizontal.
    /// Of one side of the leaves as drawn, m^2; of needles over flatLeafArea().
    float leafAreaDrawn = 0.0f;
    float leafAreaMechanics = 0.0f; ///< What the laws of motion take it for, m^2.
    float hueSpread = 0.0f;         ///< 10th to 90th percentile of a lit crown's leaves, degrees.
    float greenShare = 0.0f;        ///< Mean of G / (R + G + B) over them, of sRGB values.
};

/// Means over three shapes of the species as they grow, unscaled. Without graphics, in about a second.
TreeLooks measureLooks(const Species& species);

} // namespace osgTreeWind
