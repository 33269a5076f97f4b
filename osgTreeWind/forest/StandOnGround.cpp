// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/StandOnGround.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <map>

namespace osgTreeWind {

namespace {

/// Radii of trunks, for which shapes are grown where a tree's own is not measured.
class Trunks {
public:
    explicit Trunks(const ForestDescription& forest) : _families(forest) {}

    double radius(const TreePlacement& tree) {
        if (tree.size.trunkDiameter > 0.0f)
            return 0.5 * static_cast<double>(tree.size.trunkDiameter);
        const std::size_t index = _families.indexOf(tree);
        const ShapeFamilies::Family& family = _families.all()[index];
        const auto [found, isNew] = _natural.try_emplace({index, tree.seed % family.shapes});
        TreeSize& natural = found->second;
        if (isNew)
            natural = measureTree(makeTreeModel(family.tree, found->first.second));
        const float scale = tree.size.height > 0.0f ? tree.size.height / natural.height : 1.0f;
        return 0.5 * static_cast<double>(natural.trunkDiameter * scale);
    }

private:
    ShapeFamilies _families;
    std::map<std::pair<std::size_t, std::uint32_t>, TreeSize> _natural; ///< By family and shape.
};

std::string nameOf(const ForestDescription& forest, std::size_t index) {
    const TreePlacement& tree = forest.trees[index];
    return "tree[" + std::to_string(index) + ']' +
           (tree.name.empty() ? "" : " (id " + inQuotes(tree.name) + ')') + " at (" +
           numberText(tree.position.x) + ", " + numberText(tree.position.y) + ')';
}

} // namespace

Diagnostics standOnGround(ForestDescription& forest, const std::vector<std::size_t>& trees) {
    if (!forest.ground)
        return {};
    Trunks trunks(forest);
    std::vector<std::size_t> groundless;
    for (const std::size_t index : trees) {
        TreePlacement& tree = forest.trees[index];
        if (const auto height = footHeight(*forest.ground, glm::dvec2(tree.position), trunks.radius(tree)))
            tree.position.z = *height;
        else
            groundless.push_back(index);
    }
    if (groundless.empty())
        return {};
    return {keyProblem("ground", "no ground below " + std::to_string(groundless.size()) + " of " +
                                     std::to_string(forest.trees.size()) + " trees, first " +
                                     nameOf(forest, groundless.front()) +
                                     ": there is a hole, or it is beyond the edge")};
}

} // namespace osgTreeWind
