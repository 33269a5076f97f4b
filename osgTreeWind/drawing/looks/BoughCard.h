// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

namespace osgTreeWind {

/// A card for one so many times as wide as that of a spray: that number squared of sprays, each as small as
/// that, which cover as much of it as they do of theirs.
/// @param sprays of the same size, at least one; half of which the card is wide.
LeafTexels paintBough(const std::vector<LeafTexels>& sprays, int growth, int variant);

} // namespace osgTreeWind
