// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Shares of a leaf card.
struct CardCoverage {
    float leaves; ///< What leaves cover, twigs between them left out, as sprays are painted (LeafSprayTest).
    float twigs;  ///< What twigs cover when bare; sprays are painted to it.
};

/// In the order of LeafForm.
constexpr CardCoverage cardCoverages[] = {{0.41f, 0.13f},  {0.455f, 0.13f}, {0.455f, 0.15f}, {0.395f, 0.13f},
                                          {0.437f, 0.13f}, {0.31f, 0.13f},  {0.483f, 0.13f}, {0.478f, 0.085f},
                                          {0.355f, 0.13f}, {0.45f, 0.13f},  {0.355f, 0.07f}, {0.335f, 0.07f},
                                          {0.39f, 0.07f},  {0.53f, 0.02f}};

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
