// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/TileFiles.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace osgTreeWind {

std::string nameOfTile(const ForestTiles& tiles, std::size_t tile) {
    return std::to_string(tile % tiles.columns) + '_' + std::to_string(tile / tiles.columns);
}

std::string fileOfTile(const ForestTiles& tiles, std::size_t tile) {
    return tiles.folder + '/' + nameOfTile(tiles, tile) + ".trees";
}

std::string fileOfCrowns(const ForestTiles& tiles) {
    return tiles.folder + "/all.crowns";
}

std::string fileOfIds(const ForestTiles& tiles, std::uint32_t file) {
    return tiles.folder + '/' + std::to_string(file) + ".ids";
}

std::optional<std::uint32_t> idFileOf(const ForestTiles& tiles, const std::string& name) {
    if (tiles.idFiles == 0)
        return {};
    std::uint32_t hash = 2166136261u; // FNV-1a
    for (const char letter : name)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
    return hash % tiles.idFiles;
}

std::optional<std::size_t> tileOfPlace(const ForestTiles& tiles, const std::string& place) {
    std::uint32_t column = 0, row = 0, number = 0;
    const char* next = place.data();
    const char* const end = next + place.size();
    const auto parse = [&](std::uint32_t& value, char separator) {
        const auto [stop, error] = std::from_chars(next, end, value);
        const bool isSeparated = separator ? stop < end && *stop == separator : stop == end;
        next = stop + 1;
        return error == std::errc() && isSeparated;
    };
    if (!parse(column, '_') || !parse(row, '/') || !parse(number, '\0') || column >= tiles.columns ||
        row >= tiles.rows())
        return {};
    return static_cast<std::size_t>(row) * tiles.columns + column;
}

double defaultTileRange(const ForestTiles& tiles) {
    constexpr double treesInRange = 50000.0, minRange = 1000.0, maxRange = 5000.0;
    const auto withTrees = std::count_if(tiles.tiles.begin(), tiles.tiles.end(),
                                         [](const ForestTiles::Tile& tile) { return tile.trees > 0; });
    const double area = static_cast<double>(withTrees) * tiles.size * tiles.size,
                 trees = std::max(static_cast<double>(tiles.treeCount()), 1.0);
    return std::round(
        std::clamp(std::sqrt(treesInRange * area / trees / glm::pi<double>()), minRange, maxRange));
}

} // namespace osgTreeWind
