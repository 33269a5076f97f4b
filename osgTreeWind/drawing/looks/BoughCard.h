// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

namespace osgTreeWind {

/// A card for one so many times as wide as that of a spray: that number squared of sprays, each as small as
/// that, which cover as much of it as they do of theirs; of sparse ones as many more as that takes.
/// @param sparse at least one, of the size of the full spray, half of which the card is wide.
/// @param onRibs they are segments of fronds: side by side on both sides of ribs. Else they lie anyhow.
LeafTexels paintBough(const std::vector<LeafTexels>& sparse, const LeafTexels& full, int growth, int variant,
                      bool onRibs = false);

} // namespace osgTreeWind
