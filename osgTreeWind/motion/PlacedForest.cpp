// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/PlacedForest.h>

#include <osgTreeWind/motion/GrowthLaws.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

std::size_t shapeCount(const Species& species) {
    return static_cast<std::size_t>(std::clamp(species.shapes, 1, 64));
}

} // namespace

PlacedForest::PlacedForest(ForestDescription given) : description(std::move(given)) {
    auto& placements = description.trees;
    placements.erase(std::remove_if(placements.begin(), placements.end(),
                                    [&](const TreePlacement& placement) {
                                        return placement.species >= description.species.size();
                                    }),
                     placements.end());

    std::vector<std::size_t> firstModel;
    for (const Species& species : description.species) {
        firstModel.push_back(models.size());
        for (std::size_t shape = 0; shape < shapeCount(species); ++shape)
            models.push_back(makeTreeModel(species.tree, static_cast<std::uint32_t>(shape)));
    }
    trees.reserve(placements.size());
    for (const TreePlacement& placement : placements) {
        PlacedTree tree;
        tree.species = placement.species;
        tree.model = firstModel[tree.species] + placement.seed % shapeCount(speciesOf(tree));
        tree.scale =
            fitTree(modelOf(tree), withCrown(placement.size, speciesOf(tree).crown, placement.openGrown));
        tree.position = glm::vec3(placement.position - description.origin);
        tree.heading = placement.heading;
        tree.leaves = placement.leaves;
        tree.seed = placement.seed;
        tree.firstUnit = units;
        tree.firstLeaf = leaves;
        units += unitsOf(tree);
        leaves += leavesOf(tree);
        trees.push_back(tree);
    }
}

glm::vec3 turnHeading(const glm::vec3& v, float sine, float cosine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

} // namespace osgTreeWind
