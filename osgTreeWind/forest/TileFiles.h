// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestTiles.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace osgTreeWind {

/// "COLUMN_ROW".
std::string nameOfTile(const ForestTiles& tiles, std::size_t tile);
/// "FOLDER/COLUMN_ROW.trees"; TileTrees.h says what is in it.
std::string fileOfTile(const ForestTiles& tiles, std::size_t tile);
/// "FOLDER/all.crowns"; CrownSheet.h says what is in it.
std::string fileOfCrowns(const ForestTiles& tiles);
/// "FOLDER/N.ids"; TileIds.h says what is in it.
std::string fileOfIds(const ForestTiles& tiles, std::uint32_t file);
/// Number of the `.ids` file that a name is in; nothing where no tree has a name of its own.
std::optional<std::uint32_t> idFileOf(const ForestTiles& tiles, const std::string& name);
/// The tile of a tree by its tile and its number in it, "COLUMN_ROW/N", which is the name of a tree without
/// its own.
std::optional<std::size_t> tileOfPlace(const ForestTiles& tiles, const std::string& place);

/// The range within which some 50,000 trees of that density stand, from 1 to 5 km.
double rangeOfTiles(const ForestTiles& tiles);

} // namespace osgTreeWind
