// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

namespace osgTreeWind {

/// Paints the card of a bough, which is `enlargement` times as wide as the card of a spray. It holds shrunken
/// sparse sprays, at least enlargement² of them, and covers the same share as the full spray does of its
/// card.
/// @param sparse at least one spray with few leaves, of the size of the full one; the result has half that
/// size.
/// @param onRibs whether the sprays are segments of fronds on both sides of ribs, instead of scattered.
LeafTexels paintBough(const std::vector<LeafTexels>& sparse, const LeafTexels& full, int enlargement,
                      int variant, bool onRibs = false);

} // namespace osgTreeWind
