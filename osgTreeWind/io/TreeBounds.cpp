// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeBounds.h>

#include <glm/common.hpp>

namespace osgTreeWind {

void TreeBounds::add(const TreePlacement& tree) {
    low = count == 0 ? tree.position : glm::min(low, tree.position);
    high = count == 0 ? tree.position : glm::max(high, tree.position);
    (tree.openGrown ? inOpen : inForest).insert(tree.species);
    named += tree.name.empty() ? 0 : 1;
    ++count;
}

void TreeBounds::add(const std::vector<TreePlacement>& trees) {
    for (const TreePlacement& tree : trees)
        add(tree);
}

void TreeBounds::addSpeciesNames(const std::vector<Species>& species, ForestTiles& tiles) const {
    for (const std::size_t index : inForest)
        tiles.inForest.push_back(species[index].name);
    for (const std::size_t index : inOpen)
        tiles.inOpen.push_back(species[index].name);
}

} // namespace osgTreeWind
