// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/io/CrownSheet.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// Writes the files of tiles as their trees come, some at a time. A file has another name until it is whole.
class TileWriter {
public:
    /// @param world without trees, with tiles that have no trees yet, in a folder without their files.
    TileWriter(const ForestDescription& world, Executor executor);

    /// Those that come next. @return false where they cannot be written.
    bool add(const std::vector<TreePlacement>& trees);
    /// All have come. @return false where a file cannot be written.
    bool finish();

    /// With the trees so far.
    const ForestTiles& tiles() const { return _tiles; }
    const PlacedForest& shapes() const { return _shapes; }

private:
    bool addToTile(std::size_t tile, const std::vector<TreePlacement>& all,
                   const std::vector<std::uint32_t>& trees);

    ForestTiles _tiles;
    Executor _executor;
    PlacedForest _shapes;
    std::vector<CrownSums> _crowns; ///< Per tile.
    std::vector<bool> _idFiles;     ///< Those that are begun.
    bool _failed = false;
};

} // namespace osgTreeWind
