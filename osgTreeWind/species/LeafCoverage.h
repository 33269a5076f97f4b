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
constexpr CardCoverage cardCoverages[] = {{0.33f, 0.13f}, {0.33f, 0.13f}, {0.33f, 0.15f}, {0.32f, 0.13f},
                                          {0.38f, 0.15f}, {0.29f, 0.13f}, {0.46f, 0.13f}, {0.34f, 0.085f},
                                          {0.40f, 0.13f}, {0.37f, 0.13f}, {0.31f, 0.07f}, {0.30f, 0.07f},
                                          {0.33f, 0.07f}, {0.42f, 0.02f}, {0.33f, 0.13f}};

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
