// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Trees of a square of a tile, as they look from afar.
struct CrownCell {
    std::uint32_t column = 0, row = 0; ///< Of cells, from the corner of tile (0, 0).
    std::uint32_t trees = 0;
    float foot = 0.0f;       ///< Mean, metres in the world's frame.
    float height = 0.0f;     ///< Mean, metres.
    float width = 0.0f;      ///< Of a crown, so that all cover what they do: metres.
    std::size_t species = 0; ///< Of most trees: index into CrownSheet::species.
};

/// All trees of a world as they look from afar: CSV with a header, a row for each cell that has any.
struct CrownSheet {
    /// Of some 125 m, 1 to 8 on each side of a tile.
    static std::uint32_t cellsAcrossTile(const ForestTiles& tiles);

    std::vector<std::string> species; ///< Names.
    std::vector<CrownCell> cells;
};

/// @return all of it, or what is wrong, at which line. Thread-safe.
Result<CrownSheet> readCrownSheet(std::istream& input, const std::string& file);
std::string crownSheetHead();
/// The rows of one tile. Thread-safe. @param shapes of `forest`, without its trees.
std::string crownSheetText(const ForestDescription& forest, const PlacedForest& shapes,
                           const std::vector<std::uint32_t>& trees, const ForestTiles& tiles);

} // namespace osgTreeWind
