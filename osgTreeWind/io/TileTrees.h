// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Trees by themselves, as a tile holds them: CSV with a header, a row each.
///
/// Columns are species (a name), x, y, z (of the world, to a tenth of a millimetre), heading (radians),
/// height, trunk_diameter, crown_width (metres; empty: not given), leaves (empty: 1), seed, open_grown (1, or
/// empty), estimated (h, d and w for the sizes that nobody measured), id.
struct TileTrees {
    std::vector<std::string> species; ///< Names; TreePlacement::species counts in them.
    std::vector<TreePlacement> trees;

    /// Has TreePlacement::species count in these, and calls trees without an id by the tile's name and their
    /// place in it: "3_4/17". @param count of trees that there have to be.
    /// @return what does not fit; empty when all is well.
    Diagnostics fit(const std::vector<Species>& known, std::size_t count, const std::string& file);
};

/// @return all of it, or what is wrong, at which line. Thread-safe.
Result<TileTrees> readTileTrees(std::istream& input, const std::string& file);

/// The trees of one tile, but for those that are removed; none where the tile has none. Thread-safe.
Result<std::vector<TreePlacement>> readTile(const std::vector<Species>& species, const ForestTiles& tiles,
                                            std::size_t tile);

std::string tileHead();
/// What readTileTrees() reads, to the bit but for places. Thread-safe. @param trees some of them, by number.
/// @param species of the forest.
std::string tileRows(const std::vector<TreePlacement>& all, const std::vector<std::uint32_t>& trees,
                     const std::vector<Species>& species);

} // namespace osgTreeWind
