// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/Species.h>

namespace osgTreeWind {

/// Share of a leaf card that leaves cover, twigs between them left out: held by LeafSprayTest.
constexpr float leafCoverage(LeafForm form) {
    switch (form) {
    case LeafForm::Blade:
        return 0.45f;
    case LeafForm::Lobed:
        return 0.51f;
    case LeafForm::Ovate:
        return 0.52f;
    case LeafForm::Rhombic:
        return 0.45f;
    case LeafForm::Palmate:
        return 0.50f;
    case LeafForm::Pinnate:
        return 0.35f;
    case LeafForm::Heart:
        return 0.52f;
    case LeafForm::Round:
        return 0.51f;
    case LeafForm::Fingered:
        return 0.43f;
    case LeafForm::Fan:
        return 0.56f;
    case LeafForm::Needles:
        return 0.35f;
    case LeafForm::Bundles:
        return 0.34f;
    case LeafForm::Tufts:
        return 0.39f;
    case LeafForm::Frond:
        return 0.53f;
    }
    return 0.45f;
}

/// Share of a leaf card that its twigs cover when bare: sprays are painted to it.
constexpr float twigCoverage(LeafForm form) {
    return form == LeafForm::Frond ? 0.02f : form == LeafForm::Fingered ? 0.05f : 0.07f;
}

/// Area that the leaf cards of a tree need, one side, over its trunk's cross-section, so that the leaves on them
/// have WoodParameters::leafArea.
inline float cardArea(const Species& species) {
    return species.wood.leafArea / leafCoverage(species.appearance.leafForm);
}

} // namespace osgTreeWind
