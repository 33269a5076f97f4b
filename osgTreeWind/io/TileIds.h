// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <istream>
#include <string>
#include <unordered_map>

namespace osgTreeWind {

/// Where trees with names of their own stand: CSV with a header, the columns id and place, which is the tile
/// and the tree's number in it ("3_4/17"). One of the files over which a world's names are spread
/// (idFileOf()).
using TileIds = std::unordered_map<std::string, std::string>;

/// @return all of it, or what is wrong, at which line. Thread-safe.
Result<TileIds> readTileIds(std::istream& input, const std::string& file);
std::string tileIdsHead();
std::string tileIdsRow(const std::string& id, const std::string& place);

} // namespace osgTreeWind
