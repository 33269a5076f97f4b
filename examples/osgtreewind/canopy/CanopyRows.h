// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/AreaSums.h>
#include <examples/osgtreewind/canopy/CanopyGrid.h>
#include <osgTreeWind/base/Span.h>

#include <functional>

namespace osgTreeWind {

/// The cells of a grid with the same y: the lowest level from west to east, then the next level.
struct CanopyRow {
    int row = 0;      ///< Counted from the south.
    Span<float> leaf; ///< Leaf area density, m^2/m^3.
    Span<float> drag; ///< CdA density, m^2/m^3.
};

/// Areas of the forest inside and outside a grid.
struct CanopyTally {
    AreaSums within, beyond;
    std::size_t trees = 0; ///< Number of trees with a part in the grid.
    bool finished = true;  ///< False if it was stopped.
};

/// Bytes of memory that spreadCanopy() needs: for as many rows as the widest tree covers.
std::uint64_t canopyBytes(const PlacedForest& forest, const CanopyGrid& grid);

/// Distributes the areas of all trees at rest over a grid.
/// @param use called for each row, from the south; returns false to stop.
CanopyTally spreadCanopy(const PlacedForest& forest, const CanopyGrid& grid,
                         const std::function<bool(const CanopyRow&)>& use);

} // namespace osgTreeWind
