// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <glm/gtc/constants.hpp>

namespace osgTreeWind {

/// Shares of a leaf card that painted sprays cover.
struct CardCoverage {
    float leaves; ///< Share covered by leaves, without the twigs between them.
    float twigs;  ///< Share covered by bare twigs.
};

/// In the order of LeafForm.
constexpr CardCoverage cardCoverages[] = {
    {0.25f, 0.16f},  // blade
    {0.25f, 0.17f},  // lobed
    {0.20f, 0.20f},  // ovate
    {0.23f, 0.17f},  // rhombic
    {0.23f, 0.125f}, // palmate
    {0.23f, 0.13f},  // pinnate
    {0.24f, 0.09f},  // heart
    {0.19f, 0.06f},  // round
    {0.28f, 0.145f}, // fingered
    {0.27f, 0.12f},  // fan
    {0.31f, 0.07f},  // needles
    {0.26f, 0.06f},  // bundles
    {0.33f, 0.07f},  // tufts
    {0.42f, 0.02f},  // frond
    {0.25f, 0.16f},  // pointed
    {0.31f, 0.07f}   // combed
};

constexpr float leafCoverage(LeafForm form) {
    return cardCoverages[static_cast<int>(form)].leaves;
}
constexpr float twigCoverage(LeafForm form) {
    return cardCoverages[static_cast<int>(form)].twigs;
}

/// Factor from one-sided leaf area to the flat leaf area with the same mean projection: averaged over all
/// directions, a flat leaf shows half of its area, a round needle pi/4.
constexpr float flatLeafArea(LeafForm form) {
    return isNeedles(form) ? glm::half_pi<float>() : 1.0f;
}

/// One-sided area of a tree's leaf cards / trunk cross-section that gives WoodParameters::leafArea.
inline float cardAreaRatio(const Species& species) {
    const LeafForm form = species.appearance.leafForm;
    return species.wood.leafArea * flatLeafArea(form) / leafCoverage(form);
}

} // namespace osgTreeWind
