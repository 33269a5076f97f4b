// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Trees in square tiles, one file per tile, that are loaded around the camera (docs/worlds.md).
struct OSGTREEWIND_EXPORT ForestTiles {
    /// What is known of a tile before it loads.
    struct Tile {
        std::uint32_t trees = 0; ///< Number of trees. A tile without trees has no file.
        float low = 0.0f;        ///< Lowest foot of its trees, world z in metres.
        float high = 0.0f;       ///< Highest foot of its trees, world z in metres.
    };

    std::string folder;        ///< Path or URL of the tile files, for OSG to read.
    double size = 1000.0;      ///< Side of a tile, metres, [10, 100000].
    glm::dvec2 corner{0.0};    ///< South-west corner of tile (0, 0), world coordinates.
    std::uint32_t columns = 0; ///< Number of tiles eastward.
    /// Distance from the camera to the nearest point of a tile at which it loads, metres, [10, 100000].
    double range = 2000.0;
    std::vector<Tile> tiles;           ///< Row-major from the south-west; whole rows.
    std::vector<std::string> inForest; ///< Names of species with trees in a stand.
    std::vector<std::string> inOpen;   ///< Names of species with open-grown trees.
    std::set<std::string> removed;     ///< Names of permanently removed trees.
    std::uint32_t idFiles = 0;         ///< Number of files that map tree ids to tiles.

    /// Number of tiles northward.
    std::uint32_t rows() const { return columns ? static_cast<std::uint32_t>(tiles.size() / columns) : 0; }
    std::size_t treeCount() const; ///< Trees of all tiles.
    /// South-west corner of a tile, world coordinates.
    glm::dvec2 cornerOf(std::size_t tile) const;
};

} // namespace osgTreeWind
