// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/GroundPlacer.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgTreeWind {

namespace {

std::string nameOf(const TreePlacement& tree, std::size_t index) {
    return "tree[" + std::to_string(index) + ']' +
           (tree.name.empty() ? "" : " (id " + inQuotes(tree.name) + ')') + " at (" +
           numberText(tree.position.x) + ", " + numberText(tree.position.y) + ')';
}

} // namespace

/// Grows the tree's shape if its trunk diameter is not given.
double GroundPlacer::trunkRadius(const TreePlacement& tree) {
    if (tree.size.trunkDiameter > 0.0f)
        return 0.5 * static_cast<double>(tree.size.trunkDiameter);
    const std::size_t index = _families.indexOf(tree);
    const ShapeFamilies::Family& family = _families.all()[index];
    const auto [found, isNew] = _shapeSizes.try_emplace({index, tree.seed % family.shapes});
    TreeSize& shapeSize = found->second;
    if (isNew)
        shapeSize = measureTree(*sharedTreeModel(family.tree, found->first.second));
    const float scale = tree.size.height > 0.0f ? tree.size.height / shapeSize.height : 1.0f;
    return 0.5 * static_cast<double>(shapeSize.trunkDiameter * scale);
}

void GroundPlacer::place(std::vector<TreePlacement>& trees, const std::vector<std::size_t>& indices) {
    for (const std::size_t index : indices) {
        TreePlacement& tree = trees[index];
        if (const auto height = footHeight(_ground, glm::dvec2(tree.position), trunkRadius(tree)))
            tree.position.z = *height;
        else if (_groundless++ == 0)
            _firstGroundless = nameOf(tree, _trees + index) + ": " + reasonAt(glm::dvec2(tree.position));
    }
    _trees += trees.size();
}

std::string GroundPlacer::reasonAt(const glm::dvec2& place) const {
    const GroundArea area = _ground.area();
    if (glm::all(glm::lessThanEqual(area.low, place)) && glm::all(glm::lessThanEqual(place, area.high)))
        return "the ground has a hole there";
    const glm::dvec2 low = glm::round(area.low), high = glm::round(area.high); // a metre is enough here
    return "the ground extends over x " + rangeText(low.x, high.x) + ", y " + rangeText(low.y, high.y);
}

Diagnostics GroundPlacer::problems() const {
    if (_groundless == 0)
        return {};
    return {keyProblem("ground", "no ground below " + std::to_string(_groundless) + " of " +
                                     std::to_string(_trees) + " trees, first " + _firstGroundless)};
}

} // namespace osgTreeWind
