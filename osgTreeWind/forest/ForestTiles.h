// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Trees that lie in a folder in square tiles, a file each, and come and go with the camera (docs/worlds.md).
struct ForestTiles {
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
    /// "COLUMN_ROW".
    std::string nameOf(std::size_t tile) const;
    /// "FOLDER/COLUMN_ROW.trees"; TileTrees.h says what is in it.
    std::string fileOf(std::size_t tile) const;
    /// "FOLDER/all.crowns"; CrownSheet.h says what is in it.
    std::string fileOfCrowns() const { return folder + "/all.crowns"; }
    /// "FOLDER/N.ids"; TileIds.h says what is in it.
    std::string fileOfIds(std::uint32_t file) const { return folder + '/' + std::to_string(file) + ".ids"; }
    /// Which of them a name is in. Nothing where no tree has a name of its own.
    std::optional<std::uint32_t> idFileOf(const std::string& name) const;
    /// Of a tree by its tile and its number in it, "COLUMN_ROW/N"; that is the name of one without its own.
    std::optional<std::size_t> tileOf(const std::string& place) const;
};

/// So far that some 50,000 trees of that density are in range, from 1 to 5 km.
double rangeOfTiles(const ForestTiles& tiles);

} // namespace osgTreeWind
