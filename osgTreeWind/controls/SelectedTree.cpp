// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/SelectedTree.h>

#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/SimulationAccess.h>
#include <osgTreeWind/motion/sway/FreeSwayTree.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace osgTreeWind {

SelectedTree::SelectedTree(const ForestSimulation& simulation, TreeId tree) : _tree(tree) {
    if (!simulation.holds(tree))
        return;
    const std::size_t slot = simulation.slotOf(tree);
    const PlacedForest& forest = SimulationAccess::forest(simulation);
    const PlacedTree& placed = forest.trees[slot];
    const Species& species = forest.speciesOf(placed);
    const TreeSize size = forest.sizeOf(placed);
    const std::string name = simulation.nameOf(tree);
    _description =
        "tree    " + (name.empty() ? std::to_string(slot) : name) + ", " + species.name +
        formatted(": %.1f m high, trunk of %.0f cm, crown of %.1f m", static_cast<double>(size.height),
                  100.0 * static_cast<double>(size.trunkDiameter), static_cast<double>(size.crownWidth));
    if (!SimulationAccess::modal(simulation))
        return;
    TreePlacement alone = simulation.placementOf(tree);
    alone.leaves = placed.leaves;
    const FreeSwayTree calm(species, alone);
    _frequency = calm.modes().empty() ? 0.0 : calm.omega(0) / glm::two_pi<double>();
    const TreeModel& model = forest.modelOf(placed);
    _foot = BreakableJoint{0, makeUnitLoads(model, placed.scale, species, placed.leaves)[0].stiffness, 0.0f};
    _strength = TreeStrength(model, placed.scale, species);
}

std::string SelectedTree::swayText(const ForestSimulation& simulation) const {
    if (!simulation.isStanding(_tree))
        return "\nsway    fallen";
    const std::size_t slot = simulation.slotOf(_tree);
    const ModalMotion& sway = *SimulationAccess::modal(simulation);
    std::string text = formatted("\nsway    %.2f Hz, leans %.2f m", _frequency,
                                 static_cast<double>(glm::length(sway.lean(slot))));
    const double moment = _foot->moment(sway, slot), uproot = _strength.uproot, breaking = _strength.breaking,
                 limit =
                     uproot > 0.0 && breaking > 0.0 ? std::min(uproot, breaking) : std::max(uproot, breaking);
    text += formatted(", %.1f kN m at the foot", 0.001 * moment);
    if (limit > 0.0)
        text += formatted(" (limit %.0f)", 0.001 * limit);
    return text;
}

std::string SelectedTree::text(const ForestSimulation& simulation) const {
    if (!simulation.holds(_tree))
        return {};
    return _foot && SimulationAccess::modal(simulation) ? _description + swayText(simulation) : _description;
}

} // namespace osgTreeWind
