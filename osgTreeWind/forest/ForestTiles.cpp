// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestTiles.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
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

std::string ForestTiles::fileOf(std::size_t tile) const {
    return folder + '/' + std::to_string(tile % columns) + '_' + std::to_string(tile / columns) + ".trees";
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
