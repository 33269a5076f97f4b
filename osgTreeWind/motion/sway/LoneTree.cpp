// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/sway/LoneTree.h>

#include <utility>

namespace osgTreeWind {

PlacedForest loneTree(const Species& species, const TreePlacement& tree) {
    ForestDescription forest;
    forest.species = {species};
    forest.trees = {tree};
    forest.trees[0].species = 0;
    forest.trees[0].position = glm::dvec3(0.0);
    forest.trees[0].heading = 0.0f;
    return PlacedForest(std::move(forest));
}

ModalTree swayingTree(const PlacedForest& forest) {
    const PlacedTree& tree = forest.trees.front();
    return {{&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves}, glm::vec3(0.0f), 0.0f};
}

} // namespace osgTreeWind
