// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/laws/Motion.h>

#include <memory>
#include <utility>
#include <vector>

namespace osgTreeWind {

class GivenWind;

/// What a ForestSimulation is made of: for the library's own files and its tests.
struct SimulationParts {
    /// A simulation that takes its wind from `wind`, whatever its description says.
    static std::shared_ptr<ForestSimulation>
    make(ForestDescription description, const SimulationOptions& options, std::shared_ptr<GivenWind> wind) {
        return std::shared_ptr<ForestSimulation>(
            new ForestSimulation(std::move(description), options, std::move(wind)));
    }

    /// Trees at rest.
    static const PlacedForest& forest(const ForestSimulation& simulation) { return *simulation._forest; }
    /// By slot: in the order of the description, then as they were added. Not all of them are alive.
    static const std::vector<PlacedTree>& trees(const ForestSimulation& simulation) {
        return forest(simulation).trees;
    }
    /// Shapes, shared by trees.
    static const SharedModels& models(const ForestSimulation& simulation) {
        return forest(simulation).models();
    }
    /// Home of ForestSimulation::wind().
    static const std::shared_ptr<GivenWind>& wind(const ForestSimulation& simulation) {
        return simulation._wind;
    }

    /// The trees under the law `modal`, which also knows how closely each is followed; null under another
    /// law. They come and go through ForestSimulation only.
    static ModalMotion* modal(ForestSimulation& simulation) { return simulation._motion->modal(); }
    static const ModalMotion* modal(const ForestSimulation& simulation) {
        return simulation._motion->modal();
    }
    /// The branches, where each has a state; null under `modal`.
    static BranchwiseMotion* branches(ForestSimulation& simulation) { return simulation._motion->branches(); }
    static const BranchwiseMotion* branches(const ForestSimulation& simulation) {
        return simulation._motion->branches();
    }

    /// ForestSimulation::removeTree() of a tree that may come again with its tile.
    static Diagnostics unloadTree(ForestSimulation& simulation, TreeId tree) {
        return simulation.unloadTree(tree);
    }
    /// Instead of ForestSimulation::advance(), for those who work out states elsewhere
    /// (gpu/branchwise/AnglePrePass.h): moves on to `time` and samples the wind. @return whether to take a
    /// step; else the state is to be kept.
    static bool beginStep(ForestSimulation& simulation, double time) { return simulation.beginStep(time); }
};

} // namespace osgTreeWind
