// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/laws/Motion.h>

#include <memory>
#include <utility>
#include <vector>

namespace osgTreeWind {

class HostWind;

/// Access to the parts of a ForestSimulation for the library itself and for its tests.
struct SimulationAccess {
    /// A simulation that reads its wind from `wind` instead of from its description.
    static std::shared_ptr<ForestSimulation>
    make(ForestDescription description, const SimulationOptions& options, std::shared_ptr<HostWind> wind) {
        return std::shared_ptr<ForestSimulation>(
            new ForestSimulation(std::move(description), options, std::move(wind)));
    }

    /// The forest at rest.
    static const PlacedForest& forest(const ForestSimulation& simulation) { return *simulation._forest; }
    /// By slot, in the order of the description, then in the order of addition. Some are not alive.
    static const std::vector<PlacedTree>& trees(const ForestSimulation& simulation) {
        return forest(simulation).trees;
    }
    /// Shapes, shared by trees.
    static const SharedModels& models(const ForestSimulation& simulation) {
        return forest(simulation).models();
    }
    /// Holds ForestSimulation::wind().
    static const std::shared_ptr<HostWind>& wind(const ForestSimulation& simulation) {
        return simulation._wind;
    }

    /// The trees under the law `modal`; null under a branchwise law. Only ForestSimulation may add and remove
    /// trees.
    static ModalMotion* modal(ForestSimulation& simulation) { return simulation._motion->modal(); }
    static const ModalMotion* modal(const ForestSimulation& simulation) {
        return simulation._motion->modal();
    }
    /// The branch states of a branchwise law; null under `modal`.
    static BranchwiseMotion* branches(ForestSimulation& simulation) { return simulation._motion->branches(); }
    static const BranchwiseMotion* branches(const ForestSimulation& simulation) {
        return simulation._motion->branches();
    }

    /// Like ForestSimulation::removeTree(), but the tree returns when its tile is loaded again.
    static Diagnostics unloadTiledTree(ForestSimulation& simulation, TreeId tree) {
        return simulation.unloadTiledTree(tree);
    }
    /// Replaces ForestSimulation::advance() where states are computed elsewhere
    /// (gpu/branchwise/ForestAnglePasses.h): sets the time and samples the wind. @return whether to take a
    /// step; otherwise the states stay unchanged.
    static bool beginStep(ForestSimulation& simulation, double time) { return simulation.beginStep(time); }
};

} // namespace osgTreeWind
