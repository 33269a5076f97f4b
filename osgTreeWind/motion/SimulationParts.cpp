// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/SimulationParts.h>

#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/modal/ModalForest.h>

#include <utility>

namespace osgTreeWind {

std::shared_ptr<ForestSimulation> SimulationParts::make(ForestDescription description,
                                                        const SimulationOptions& options,
                                                        std::shared_ptr<GivenWind> wind) {
    return std::shared_ptr<ForestSimulation>(
        new ForestSimulation(std::move(description), options, std::move(wind)));
}

ModalMotion* SimulationParts::modal(ForestSimulation& simulation) {
    auto* modal = dynamic_cast<ModalForest*>(simulation._motion.get());
    return modal ? &modal->sway() : nullptr;
}

const ModalMotion* SimulationParts::modal(const ForestSimulation& simulation) {
    return modal(const_cast<ForestSimulation&>(simulation));
}

BranchwiseMotion* SimulationParts::branches(ForestSimulation& simulation) {
    return dynamic_cast<BranchwiseMotion*>(simulation._motion.get());
}

const BranchwiseMotion* SimulationParts::branches(const ForestSimulation& simulation) {
    return branches(const_cast<ForestSimulation&>(simulation));
}

Diagnostics SimulationParts::unloadTree(ForestSimulation& simulation, TreeId tree) {
    return simulation.unloadTree(tree);
}

std::optional<float> SimulationParts::beginStep(ForestSimulation& simulation, double time) {
    return simulation.beginStep(time);
}

} // namespace osgTreeWind
