// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>
#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// Twigs and the leaves they bear, on a card whose corners are (0, 0) and (1, 1). They spring from the middle
/// of its lower edge; a segment of a frond from all of that.
struct LeafSpray {
    std::vector<TwigPiece> twigs;
    std::vector<LeafBlade> blades; ///< Those behind come first.
};

/// One of many that a form may have: as many leaves as cover leafCoverage(), and twigs twigCoverage(), or a
/// share of both. Takes milliseconds.
LeafSpray growSpray(LeafForm form, int variant = 0, float share = 1.0f);
LeafTexels paintSpray(LeafForm form, const LeafSpray& spray);

} // namespace osgTreeWind
