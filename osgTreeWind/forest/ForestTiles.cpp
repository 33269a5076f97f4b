// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestTiles.h>

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

} // namespace osgTreeWind
