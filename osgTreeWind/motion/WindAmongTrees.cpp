// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindAmongTrees.h>

#include <osgTreeWind/motion/CanopyOfTrees.h>
#include <osgTreeWind/wind/CanopyWind.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

std::vector<StandTree> standTrees(const PlacedForest& forest) {
    std::vector<StandTree> trees;
    trees.reserve(forest.trees.size());
    for (const PlacedTree& tree : forest.trees)
        if (tree.alive)
            trees.emplace_back(forest.modelOf(tree), tree.scale, forest.speciesOf(tree), tree.leaves,
                               glm::vec2(tree.position));
    return trees;
}

} // namespace

WindFieldPtr WindAmongTrees::from(const WindFieldPtr& given, const PlacedForest& forest) {
    const WindCanopy& canopy = forest.description().windCanopy;
    if (!given || canopy.source == CanopySource::None)
        return given;
    if (given == _given)
        return _met;
    const std::vector<StandTree> trees = standTrees(forest);
    const auto map =
        canopy.source == CanopySource::Forest
            ? canopyOf(trees)
            : canopyOf(trees, static_cast<float>(canopy.height), static_cast<float>(canopy.frontalArea));
    _given = given;
    _met = std::make_shared<CanopyWind>(given, map, static_cast<float>(canopy.reference), canopy.seed);
    return _met;
}

} // namespace osgTreeWind
