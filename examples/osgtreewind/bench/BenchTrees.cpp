// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchTrees.h>

#include <examples/osgtreewind/bench/BenchRows.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/wind/GustWind.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>

using namespace osgTreeWind;

namespace {

constexpr std::size_t manyTrees = 4096, posedTrees = 64; // about 1 MB of state

/// Reference trees in rows, 6 m apart.
ForestDescription referenceTrees(std::size_t count) {
    ForestDescription forest;
    forest.species.emplace_back();
    forest.species.front().shapes = 1;
    forest.trees.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        forest.trees[i].position = placeInRows(i, count, 6.0);
        forest.trees[i].heading = static_cast<float>(i);
    }
    return forest;
}

WindFieldPtr someGusts() {
    GustWind::Parameters gusts;
    gusts.profile = LogProfile{10.0, 0.5};
    return GustWind::create(gusts).value();
}

BenchKernel treeKernel(const std::string& name, std::size_t trees, unsigned threads = 1) {
    return {"laws", name, "tree", trees, {}, threads};
}

/// Steps before the first round, for trees to be in motion.
template <typename Step>
void stepUntilInMotion(Step step) {
    for (int i = -30; i < 0; ++i)
        step(static_cast<double>(i) * static_cast<double>(kernelStep));
}

/// All that a simulation does in a step. @param calm once the trees are in motion.
TimedKernel simulatedTree(const std::string& name, const WindFieldPtr& wind, bool calm,
                          unsigned threads = 1) {
    SimulationOptions options;
    options.leaves = false;
    options.executor = threads > 1 ? ThreadPool::executor(threads) : Executor(runInTurn);
    const auto simulation = std::make_shared<ForestSimulation>(referenceTrees(manyTrees), options);
    simulation->setWind(wind);
    stepUntilInMotion([&](double time) { simulation->advance(time); });
    if (calm)
        simulation->setWind(nullptr);
    return {treeKernel(name, manyTrees, threads), [=](double time) { simulation->advance(time); }};
}

/// What it takes to show a tree.
TimedKernel modalPoses(const char* name, const WindFieldPtr& wind) {
    SimulationOptions options;
    options.leaves = false;
    const auto simulation = std::make_shared<ForestSimulation>(referenceTrees(posedTrees), options);
    simulation->setWind(wind);
    stepUntilInMotion([&](double time) { simulation->advance(time); });
    return {treeKernel(name, posedTrees), [=, values = UnitValues()](double) mutable {
                for (std::size_t i = 0; i < posedTrees; ++i)
                    kernelResult = simulation->motion(i, values).states[7].x;
            }};
}

/// The law by itself, in a wind that is there.
TimedKernel modalStep(InstructionSet set) {
    const PlacedForest forest(referenceTrees(1));
    const auto archetype = std::make_shared<const Archetype>(
        SwayingTree{forest.models().front().get(), &forest.description().species.front(), {}, 1.0f});
    const ModalModel& model = archetype->model(0);
    const std::size_t floats = treeFloats(model);
    float factors[sizeof(TreeFactors) / sizeof(float)];
    const TreeFactors asItIs;
    std::memcpy(factors, &asItIs, sizeof factors);
    std::vector<TreeLanes> trees(manyTrees / TreeLanes::count * floats);
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (const std::size_t behind = floats - i % floats; behind <= std::size(factors))
            std::fill_n(trees[i].tree, TreeLanes::count, factors[std::size(factors) - behind]);
    std::vector<TreeLanes> wind(3 * model.patches.size());
    for (std::size_t i = 0; i < wind.size(); i += 3)
        std::fill_n(wind[i].tree, TreeLanes::count, 8.0f);
    return {treeKernel(std::string("modal step, ") + nameOf(set), manyTrees), [=](double) mutable {
                for (std::size_t i = 0; i < trees.size(); i += floats)
                    stepTrees({&archetype->model(0), &trees[i], wind.data(), kernelStep, 1, 1.0f}, set);
                kernelResult = trees[0].tree[0];
            }};
}

} // namespace

std::vector<TimedKernel> treeKernels() {
    const WindFieldPtr gusts = someGusts();
    const unsigned cores = ThreadPool().threadCount();
    std::vector<TimedKernel> kernels = {
        simulatedTree("modal", gusts, true), simulatedTree("modal, gusts", gusts, false),
        simulatedTree("modal, all cores", gusts, true, cores),
        simulatedTree("modal, gusts, all cores", gusts, false, cores), modalPoses("modal, poses", gusts)};
    for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
        if (set <= bestInstructionSet())
            kernels.push_back(modalStep(set));
    return kernels;
}
