// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestTiles.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace osgTreeWind {

std::size_t ForestTiles::treeCount() const {
    std::size_t count = 0;
    for (const Tile& tile : tiles)
        count += tile.trees;
    return count;
}

glm::dvec2 ForestTiles::cornerOf(std::size_t tile) const {
    return corner + size * glm::dvec2(tile % columns, tile / columns);
}

std::string ForestTiles::nameOf(std::size_t tile) const {
    return std::to_string(tile % columns) + '_' + std::to_string(tile / columns);
}

std::string ForestTiles::fileOf(std::size_t tile) const {
    return folder + '/' + nameOf(tile) + ".trees";
}

std::optional<std::uint32_t> ForestTiles::idFileOf(const std::string& name) const {
    if (idFiles == 0)
        return {};
    std::uint32_t hash = 2166136261u; // FNV-1a
    for (const char letter : name)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
    return hash % idFiles;
}

std::optional<std::size_t> ForestTiles::tileOf(const std::string& place) const {
    std::uint32_t column = 0, row = 0, number = 0;
    const char* next = place.data();
    const char* const end = next + place.size();
    const auto take = [&](std::uint32_t& value, char after) {
        const auto [stop, error] = std::from_chars(next, end, value);
        const bool ended = after ? stop < end && *stop == after : stop == end;
        next = stop + 1;
        return error == std::errc() && ended;
    };
    if (!take(column, '_') || !take(row, '/') || !take(number, '\0') || column >= columns || row >= rows())
        return {};
    return static_cast<std::size_t>(row) * columns + column;
}

double rangeOfTiles(const ForestTiles& tiles) {
    constexpr double treesInRange = 50000.0, nearest = 1000.0, farthest = 5000.0;
    const auto withTrees = std::count_if(tiles.tiles.begin(), tiles.tiles.end(),
                                         [](const ForestTiles::Tile& tile) { return tile.trees > 0; });
    const double area = static_cast<double>(withTrees) * tiles.size * tiles.size,
                 trees = std::max(static_cast<double>(tiles.treeCount()), 1.0);
    return std::round(
        std::clamp(std::sqrt(treesInRange * area / trees / glm::pi<double>()), nearest, farthest));
}

} // namespace osgTreeWind
