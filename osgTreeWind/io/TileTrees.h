// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The content of a tile file: CSV with a header and a row for each tree.
///
/// Columns are species (a name), x, y, z (world coordinates, to 0.1 mm), heading (radians), height,
/// trunk_diameter, crown_width (metres; empty: not given), leaves (empty: 1), seed, open_grown (1 or empty),
/// estimated (h, d and w for sizes that were not measured), id.
struct TileTrees {
    std::vector<std::string> species; ///< Names, to which TreePlacement::species refers.
    std::vector<TreePlacement> trees;

    /// Makes TreePlacement::species refer to `known`, and names trees without an id by the tile and their
    /// number in it: "3_4/17". @param count expected number of trees.
    Diagnostics resolve(const std::vector<Species>& known, std::size_t count, const std::string& file);
};

/// Thread-safe. @param file name for diagnostics.
Result<TileTrees> readTileTrees(std::istream& input, const std::string& file);

/// Reads the trees of one tile, except for removed ones. Thread-safe.
Result<std::vector<TreePlacement>> readTile(const std::vector<Species>& species, const ForestTiles& tiles,
                                            std::size_t tile);

std::string tileHeader();
/// Rows for readTileTrees(), exact except for positions. Thread-safe. @param trees indices into `all`.
std::string tileRows(const std::vector<TreePlacement>& all, const std::vector<std::uint32_t>& trees,
                     const std::vector<Species>& species);

} // namespace osgTreeWind
