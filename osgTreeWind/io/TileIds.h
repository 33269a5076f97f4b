// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <istream>
#include <string>
#include <unordered_map>

namespace osgTreeWind {

/// Maps ids of trees to their places, the tile and the tree's number in it ("3_4/17"): a CSV file with the
/// columns id and place. The ids of a tiled forest are distributed over several such files (idFileOf()).
using TileIds = std::unordered_map<std::string, std::string>;

/// Thread-safe. @param file name for diagnostics.
Result<TileIds> readTileIds(std::istream& input, const std::string& file);
std::string tileIdsHeader();
std::string tileIdsRow(const std::string& id, const std::string& place);

} // namespace osgTreeWind
