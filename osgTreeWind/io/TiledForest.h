// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/ForestStream.h>

#include <string>

namespace osgTreeWind {

/// How a forest is cut.
struct TilingOptions {
    double size =
        1000.0;         ///< Of a tile, metres, [10, 100000]; larger where there would be over 10,000 of them.
    double range = 0.0; ///< ForestTiles::range; 0: by how many trees there are.
    Executor executor;  ///< Null: the calling thread.
};

/// Writes a forest as a folder that Forest draws a part of at a time (docs/worlds.md): `world.treewind` and
/// `tiles/`, and a flight over it for viewers, `fly.path`. The same bytes whatever the threads.
///
/// `world.treewind` is taken away first and comes last: without it there is no world, and the same call makes
/// one. Files of tiles that were there before and are none of it are removed.
/// @return the tiles, or what keeps it from being written.
OSGTREEWIND_EXPORT Result<ForestTiles> writeTiledForest(const ForestDescription& forest,
                                                        const std::string& folder,
                                                        const TilingOptions& options = {});

/// The same of a forest that is not in memory; the same bytes, whatever of it is at once.
OSGTREEWIND_EXPORT Result<ForestTiles> writeTiledForest(const ForestStream& forest, const std::string& folder,
                                                        const TilingOptions& options = {});

/// Columns and rows of tiles, both ends included.
struct TileBox {
    std::uint32_t firstColumn = 0;  ///< The westernmost,
    std::uint32_t firstRow = 0;     ///< the southernmost,
    std::uint32_t lastColumn = ~0u; ///< the easternmost,
    std::uint32_t lastRow = ~0u;    ///< the northernmost.
};

/// Reads the trees of those tiles into the forest, which has no tiles then, and keeps of its own trees those
/// that stand there. From files, not from URLs.
/// @param margin metres around the tiles, of which all trees come behind, for what they are to the others.
/// @return how many trees of those tiles there are, which come first, or the problems.
OSGTREEWIND_EXPORT Result<std::size_t> loadTiles(ForestDescription& forest, const TileBox& box = {},
                                                 double margin = 0.0);

} // namespace osgTreeWind
