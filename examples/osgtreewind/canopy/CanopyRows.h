// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/AreaSums.h>
#include <examples/osgtreewind/canopy/CanopyGrid.h>
#include <osgTreeWind/base/Span.h>

#include <functional>

namespace osgTreeWind {

/// The cells of a grid that have the same y: all of the lowest level from west to east, then of the next.
struct CanopyRow {
    int row = 0;      ///< From the south.
    Span<float> leaf; ///< Leaf area density, m^2/m^3.
    Span<float> drag; ///< CdA density, m^2/m^3.
};

/// What lies on a grid, and what of the forest's trees beyond its sides.
struct CanopyTally {
    AreaSums within, beyond;
    std::size_t trees = 0; ///< With something on the grid.
    bool finished = true;  ///< No: it was stopped.
};

/// Bytes of main memory that spreadCanopy() is going to need: of as many rows as the widest tree reaches.
std::uint64_t canopyBytes(const PlacedForest& forest, const CanopyGrid& grid);

/// Spreads the trees of a forest, as they stand at rest, over a grid.
/// @param use called for each row, from the south; false stops.
CanopyTally spreadCanopy(const PlacedForest& forest, const CanopyGrid& grid,
                         const std::function<bool(const CanopyRow&)>& use);

} // namespace osgTreeWind
