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
/// "FOLDER/COLUMN_ROW.trees", see TileTrees.h.
std::string fileOfTile(const ForestTiles& tiles, std::size_t tile);
/// "FOLDER/all.crowns", see CrownSummary.h.
std::string fileOfCrowns(const ForestTiles& tiles);
/// "FOLDER/N.ids", see TileIds.h.
std::string fileOfIds(const ForestTiles& tiles, std::uint32_t file);
/// Number of the `.ids` file that contains a name; empty if the forest has no such files.
std::optional<std::uint32_t> idFileOf(const ForestTiles& tiles, const std::string& name);
/// Parses the tile from a tree's place "COLUMN_ROW/N", which is also the name of a tree without an id.
std::optional<std::size_t> tileOfPlace(const ForestTiles& tiles, const std::string& place);

/// A loading range that contains about 50,000 trees at the mean density, from 1 to 5 km.
double defaultTileRange(const ForestTiles& tiles);

} // namespace osgTreeWind
