// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/io/CrownSummary.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// Writes the files of a tiled forest from batches of trees.
class TileWriter {
public:
    /// @param world without trees, with empty tiles in a folder that has no files of them.
    TileWriter(const ForestDescription& world, Executor executor);

    /// Writes a batch of trees. @return false if a file cannot be written.
    bool add(const std::vector<TreePlacement>& trees);
    /// Completes the files after the last batch. @return false if a file cannot be written.
    bool finish();

    /// The tiles, with counts and heights of the trees so far.
    const ForestTiles& tiles() const { return _tiles; }
    const PlacedForest& shapes() const { return _shapes; }

private:
    bool addToTile(std::size_t tile, const std::vector<TreePlacement>& all,
                   const std::vector<std::uint32_t>& trees);

    ForestTiles _tiles;
    Executor _executor;
    PlacedForest _shapes;
    std::vector<CrownAccumulator> _crowns; ///< Per tile.
    std::vector<bool> _idFiles;            ///< Whether the file has a header.
    bool _failed = false;
};

} // namespace osgTreeWind
