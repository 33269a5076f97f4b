// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/ForestStream.h>

#include <string>

namespace osgTreeWind {

/// How a forest is divided into tiles.
struct TilingOptions {
    /// Side of a tile, metres, [10, 100000]; doubled until there are at most 10,000 tiles.
    double size = 1000.0;
    double range = 0.0; ///< ForestTiles::range; 0: chosen from the density of trees.
    Executor executor;  ///< Null: the calling thread.
};

/// Writes a tiled forest, of which Forest loads only a part at a time (docs/worlds.md): a folder with
/// `world.treewind`, `tiles/`, and `fly.path`, a camera path for viewers. Threads do not affect the files.
///
/// `world.treewind` is replaced last, after the tiles are complete. Old files of tiles are then removed.
/// @return the tiles, or an error.
OSGTREEWIND_EXPORT Result<ForestTiles> writeTiledForest(const ForestDescription& forest,
                                                        const std::string& folder,
                                                        const TilingOptions& options = {});

/// Writes the same files for a forest that is not in memory.
OSGTREEWIND_EXPORT Result<ForestTiles> writeTiledForest(const ForestStream& forest, const std::string& folder,
                                                        const TilingOptions& options = {});

/// A rectangle of tiles, inclusive at both ends.
struct TileBox {
    std::uint32_t firstColumn = 0;  ///< Westernmost column.
    std::uint32_t firstRow = 0;     ///< Southernmost row.
    std::uint32_t lastColumn = ~0u; ///< Easternmost column.
    std::uint32_t lastRow = ~0u;    ///< Northernmost row.
};

/// Replaces the tiles of a forest by the trees in a rectangle of tiles, from files only, not URLs. Of the
/// forest's other trees, it keeps those in the rectangle.
/// @param margin metres around the rectangle from which trees are appended, as neighbours of the others.
/// @return the number of trees in the rectangle, which come first, or an error.
OSGTREEWIND_EXPORT Result<std::size_t> loadTiles(ForestDescription& forest, const TileBox& box = {},
                                                 double margin = 0.0);

} // namespace osgTreeWind
