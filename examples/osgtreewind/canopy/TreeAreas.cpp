// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/TreeAreas.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

TreeAreas::TreeAreas(const PlacedForest& forest, double step)
    : _forest(forest), _step(step), _cards(forest.models().size()) {}

std::vector<UnitLoad> TreeAreas::loadsOf(const PlacedTree& tree) const {
    return makeUnitLoads(_forest.modelOf(tree), tree.scale, _forest.speciesOf(tree), tree.leaves);
}

AreaSums TreeAreas::sumOf(const PlacedTree& tree) const {
    AreaSums sum;
    for (const UnitLoad& load : loadsOf(tree))
        sum += {load.leafArea, static_cast<double>(load.woodDrag) + static_cast<double>(load.leafDrag)};
    return sum;
}

const TreeAreas::Cards& TreeAreas::cardsOf(const PlacedTree& tree) {
    Cards& cards = _cards[tree.model];
    if (!cards.list.empty())
        return cards;
    const TreeModel& model = _forest.modelOf(tree);
    const auto& mesh = model.leafMesh;
    cards.list.reserve(model.leaves.size() * mesh.size());
    for (const LeafCluster& leaf : model.leaves)
        for (std::size_t i = 0; i < mesh.size(); ++i) {
            const glm::vec3 middle = 0.5f * (middleOf(mesh, static_cast<int>(i / 4), 1) + mesh[i].corner);
            cards.list.push_back(
                {leaf.anchor, leaf.size * (leaf.orientation * middle), leaf.size * leaf.size});
            cards.size += static_cast<double>(cards.list.back().size);
        }
    return cards;
}

void TreeAreas::addWood(const PlacedTree& tree, const std::vector<UnitLoad>& loads) {
    const std::vector<BranchUnit>& units = _forest.modelOf(tree).skeleton.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (!(loads[i].woodDrag > 0.0f))
            continue;
        const ScaledUnit unit(units[i], tree.scale);
        const auto slices = static_cast<int>(std::clamp(std::ceil(unit.length / _step), 1.0, 1000.0));
        const double drag = 2.0 * static_cast<double>(loads[i].woodDrag) /
                            (slices * static_cast<double>(unit.baseDiameter + unit.tipDiameter));
        for (int slice = 0; slice < slices; ++slice) {
            const float at = (static_cast<float>(slice) + 0.5f) / static_cast<float>(slices);
            const double diameter = glm::mix(unit.baseDiameter, unit.tipDiameter, at);
            _points.push_back({unit.base + at * unit.span, {0.0, drag * diameter}});
        }
    }
}

void TreeAreas::addLeaves(const PlacedTree& tree, const AreaSums& leaves) {
    const Cards& cards = cardsOf(tree);
    const AreaSums each = leaves * (1.0 / cards.size);
    for (const Card& card : cards.list)
        _points.push_back({tree.scale.axes * card.anchor + tree.scale.leaf * card.offset,
                           each * static_cast<double>(card.size)});
}

const std::vector<TreeAreas::Point>& TreeAreas::pointsOf(const PlacedTree& tree) {
    const std::vector<UnitLoad> loads = loadsOf(tree);
    _points.clear();
    addWood(tree, loads);
    AreaSums leaves;
    for (const UnitLoad& load : loads)
        leaves += {load.leafArea, load.leafDrag};
    if (leaves.leaf > 0.0 || leaves.drag > 0.0)
        addLeaves(tree, leaves);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    for (Point& point : _points) {
        point.place = rotateAboutZ(point.place, sine, cosine);
        point.place.z = std::max(point.place.z, 0.0f); // leaves below the ground lie on it
    }
    return _points;
}

} // namespace osgTreeWind
