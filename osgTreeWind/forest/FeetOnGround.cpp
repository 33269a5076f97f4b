// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/FeetOnGround.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>

namespace osgTreeWind {

namespace {

std::string nameOf(const TreePlacement& tree, std::size_t index) {
    return "tree[" + std::to_string(index) + ']' +
           (tree.name.empty() ? "" : " (id " + inQuotes(tree.name) + ')') + " at (" +
           numberText(tree.position.x) + ", " + numberText(tree.position.y) + ')';
}

} // namespace

/// Shapes are grown where a tree's own trunk is not measured.
double FeetOnGround::trunkRadius(const TreePlacement& tree) {
    if (tree.size.trunkDiameter > 0.0f)
        return 0.5 * static_cast<double>(tree.size.trunkDiameter);
    const std::size_t index = _families.indexOf(tree);
    const ShapeFamilies::Family& family = _families.all()[index];
    const auto [found, isNew] = _natural.try_emplace({index, tree.seed % family.shapes});
    TreeSize& natural = found->second;
    if (isNew)
        natural = measureTree(*sharedTreeModel(family.tree, found->first.second));
    const float scale = tree.size.height > 0.0f ? tree.size.height / natural.height : 1.0f;
    return 0.5 * static_cast<double>(natural.trunkDiameter * scale);
}

void FeetOnGround::put(std::vector<TreePlacement>& trees, const std::vector<std::size_t>& which) {
    for (const std::size_t index : which) {
        TreePlacement& tree = trees[index];
        if (const auto height = footHeight(_ground, glm::dvec2(tree.position), trunkRadius(tree)))
            tree.position.z = *height;
        else if (_groundless++ == 0)
            _first = nameOf(tree, _trees + index);
    }
    _trees += trees.size();
}

Diagnostics FeetOnGround::problems() const {
    if (_groundless == 0)
        return {};
    return {keyProblem("ground", "no ground below " + std::to_string(_groundless) + " of " +
                                     std::to_string(_trees) + " trees, first " + _first +
                                     ": there is a hole, or it is beyond the edge")};
}

} // namespace osgTreeWind
