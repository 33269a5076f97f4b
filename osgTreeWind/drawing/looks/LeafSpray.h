// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>
#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// Twigs and their leaves on a card whose corners are (0, 0) and (1, 1). They grow from the middle of its
/// lower edge; a segment of a frond grows from the whole edge.
struct LeafSpray {
    std::vector<TwigPiece> twigs;
    std::vector<LeafBlade> blades; ///< Back to front.
};

/// Grows a random spray of a form, whose leaves cover leafCoverage() of the card and whose twigs cover
/// twigCoverage(), or `share` of both. Takes milliseconds. @param variant seed.
LeafSpray growSpray(LeafForm form, int variant = 0, float share = 1.0f);
LeafTexels paintSpray(LeafForm form, const LeafSpray& spray);

} // namespace osgTreeWind
