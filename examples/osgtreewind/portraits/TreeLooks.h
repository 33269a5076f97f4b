// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Appearance of a species in numbers that can be compared with measurements of trees.
struct TreeLooks {
    /// Share of the crown's outline through which the sky shows, seen from 25 degrees below its middle. In
    /// winter only twigs and branches count. Compare Wilkinson 1992.
    float skyThroughCrownSummer = 0.0f, skyThroughCrownWinter = 0.0f;
    float crownOverStem = 0.0f;   ///< Crown width over stem diameter at breast height.
    float leafInclination = 0.0f; ///< Mean angle of the leaf area from the horizontal, degrees.
    /// One-sided area of the leaves as drawn, m^2; for needles divided by flatLeafArea().
    float leafAreaDrawn = 0.0f;
    float leafAreaMechanics = 0.0f; ///< Leaf area in the laws of motion, m^2.
    float hueSpread = 0.0f;         ///< Range of leaf hues in a lit crown, 10th to 90th percentile, degrees.
    float greenShare = 0.0f;        ///< Mean of G / (R + G + B) of the leaves in a lit crown, sRGB.
};

/// Measures the means over three unscaled shapes of a species. Needs no graphics; takes about a second.
TreeLooks measureLooks(const Species& species);

} // namespace osgTreeWind
