// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/SelectedTree.h>

#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <glm/geometric.hpp>

#include <optional>

namespace osgTreeWind {

SelectedTree::SelectedTree(const ForestSimulation& simulation, TreeId tree) : _tree(tree) {
    if (!simulation.holds(tree))
        return;
    const std::size_t slot = slotOfTree(tree);
    const PlacedForest& forest = movingForest(simulation).placed();
    const PlacedTree& placed = forest.trees[slot];
    const Species& species = forest.speciesOf(placed);
    const TreeSize size = forest.sizeOf(placed);
    const std::string name = simulation.nameOf(tree);
    _description =
        "tree    " + (name.empty() ? std::to_string(slot) : name) + ", " + species.name +
        formatted(": %.1f m high, trunk of %.0f cm, crown of %.1f m", static_cast<double>(size.height),
                  100.0 * static_cast<double>(size.trunkDiameter), static_cast<double>(size.crownWidth));
}

std::string SelectedTree::text(const ForestSimulation& simulation) const {
    if (!simulation.holds(_tree))
        return {};
    if (!simulation.isStanding(_tree))
        return _description + "\nsway    fallen";
    const std::optional<TreeSway> sway = simulation.sway(_tree);
    if (!sway)
        return _description;
    std::string text =
        _description + formatted("\nsway    %.2f Hz, leans %.2f m, %.1f kN m at the foot", sway->frequency,
                                 static_cast<double>(glm::length(sway->displacement)),
                                 0.001 * sway->moment());
    if (sway->limit > 0.0)
        text += formatted(" (limit %.0f)", 0.001 * sway->limit);
    return text;
}

} // namespace osgTreeWind
