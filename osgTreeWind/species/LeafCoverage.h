// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <glm/gtc/constants.hpp>

namespace osgTreeWind {

/// Shares of a leaf card, which sprays are painted to.
struct CardCoverage {
    float leaves; ///< What leaves cover, twigs between them left out.
    float twigs;  ///< What twigs cover when bare.
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

/// Area of flat leaves that hides as much as leaves of this form whose area is 1. In the mean over all
/// directions a flat leaf shows half of its area, and a needle, which is round, pi/4 of it.
constexpr float flatLeafArea(LeafForm form) {
    return isNeedles(form) ? glm::half_pi<float>() : 1.0f;
}

/// Area that the leaf cards of a tree need, one side, over its trunk's cross-section, so that the leaves on
/// them have WoodParameters::leafArea.
inline float cardArea(const Species& species) {
    const LeafForm form = species.appearance.leafForm;
    return species.wood.leafArea * flatLeafArea(form) / leafCoverage(form);
}

} // namespace osgTreeWind
