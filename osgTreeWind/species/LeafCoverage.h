// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Shares of a leaf card, which sprays are painted to.
struct CardCoverage {
    float leaves; ///< What leaves cover, twigs between them left out.
    float twigs;  ///< What twigs cover when bare.
};

/// In the order of LeafForm.
constexpr CardCoverage cardCoverages[] = {{0.33f, 0.13f}, {0.33f, 0.13f}, {0.33f, 0.15f}, {0.32f, 0.13f},
                                          {0.34f, 0.15f}, {0.29f, 0.13f}, {0.46f, 0.13f}, {0.34f, 0.085f},
                                          {0.33f, 0.13f}, {0.35f, 0.13f}, {0.31f, 0.07f}, {0.30f, 0.07f},
                                          {0.33f, 0.07f}, {0.42f, 0.02f}, {0.33f, 0.13f}};

constexpr float leafCoverage(LeafForm form) {
    return cardCoverages[static_cast<int>(form)].leaves;
}
constexpr float twigCoverage(LeafForm form) {
    return cardCoverages[static_cast<int>(form)].twigs;
}

/// Area that the leaf cards of a tree need, one side, over its trunk's cross-section, so that the leaves on
/// them have WoodParameters::leafArea.
inline float cardArea(const Species& species) {
    return species.wood.leafArea / leafCoverage(species.appearance.leafForm);
}

} // namespace osgTreeWind
