// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindAmongTrees.h>

#include <osgTreeWind/wind/CanopyWind.h>

namespace osgTreeWind {

void WindAmongTrees::treeChanged(std::size_t slot) {
    if (slot < _trees.size())
        _trees[slot].reset();
    _canopy.reset();
}

void WindAmongTrees::allTreesChanged() {
    _trees.clear();
    _canopy.reset();
}

std::shared_ptr<const CanopyMap> WindAmongTrees::canopyOfForest(const PlacedForest& forest) {
    const WindCanopy& canopy = forest.description().windCanopy;
    _trees.resize(forest.trees.size());
    std::vector<StandTree> alive;
    alive.reserve(_trees.size());
    for (std::size_t slot = 0; slot < _trees.size(); ++slot) {
        const PlacedTree& tree = forest.trees[slot];
        if (!tree.alive)
            continue;
        if (!_trees[slot])
            _trees[slot].emplace(forest.modelOf(tree), tree.scale, forest.speciesOf(tree), tree.leaves,
                                 glm::vec2(tree.position));
        alive.push_back(*_trees[slot]);
    }
    return canopy.source == CanopySource::Forest
               ? canopyOf(alive)
               : canopyOf(alive, static_cast<float>(canopy.height), static_cast<float>(canopy.frontalArea));
}

WindFieldPtr WindAmongTrees::from(const WindFieldPtr& given, const PlacedForest& forest) {
    const WindCanopy& canopy = forest.description().windCanopy;
    if (!given || canopy.source == CanopySource::None)
        return given;
    if (given == _given && _canopy)
        return _met;
    if (!_canopy)
        _canopy = canopyOfForest(forest);
    _given = given;
    _met = std::make_shared<CanopyWind>(given, *_canopy, static_cast<float>(canopy.reference), canopy.seed);
    return _met;
}

} // namespace osgTreeWind
