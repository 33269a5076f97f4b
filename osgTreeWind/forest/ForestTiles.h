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

/// Trees that lie in a folder in square tiles, a file each, and come and go with the camera (docs/worlds.md).
struct OSGTREEWIND_EXPORT ForestTiles {
    /// One of them.
    struct Tile {
        std::uint32_t trees = 0; ///< None: there is no file.
        float low = 0.0f;        ///< Of its trees' feet the lowest, metres in the world's frame,
        float high = 0.0f;       ///< and the highest.
    };

    std::string folder;        ///< Of the files: a path, or a URL that OSG reads from.
    double size = 1000.0;      ///< Side of a tile, metres, [10, 100000].
    glm::dvec2 corner{0.0};    ///< Of tile (0, 0): its least x and y, in the world's frame.
    std::uint32_t columns = 0; ///< Of tiles, eastward.
    /// Metres, [10, 100000]: from where on a tile's trees are there, to the nearest place it may have a tree
    /// at.
    double range = 2000.0;
    std::vector<Tile> tiles;           ///< Row by row, eastward, then northward: whole rows.
    std::vector<std::string> inForest; ///< Names of species of which trees stand in a forest,
    std::vector<std::string> inOpen;   ///< and in the open (TreePlacement::openGrown).
    /// Names of trees of tiles that are there no more.
    std::set<std::string> removed;
    std::uint32_t idFiles = 0; ///< Over which the names are spread that trees have of their own.

    std::uint32_t rows() const {
        return columns ? static_cast<std::uint32_t>(tiles.size() / columns) : 0;
    }                              ///< Of tiles, northward.
    std::size_t treeCount() const; ///< Of all tiles.
    /// Its least x and y, in the world's frame.
    glm::dvec2 cornerOf(std::size_t tile) const;
};

} // namespace osgTreeWind
