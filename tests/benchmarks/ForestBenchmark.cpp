// SPDX-License-Identifier: MIT
// Cost of a frame on the CPU, without drawing: wind, motion, and what becomes of poses in the scene graph.
// The argument is the number of trees: 1 and 16 reference trees, 1233 the measured campus.
#include <tests/Folders.h>
#include <tests/TestData.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/Forest.h>

#include <benchmark/benchmark.h>
#include <osgUtil/UpdateVisitor>

using namespace osgTreeWind;

namespace {

constexpr double frame = 1.0 / 60.0;

/// What the benchmark is about; null, with the benchmark skipped, without data.
std::optional<ForestDescription> describe(benchmark::State& state) {
    const auto trees = static_cast<std::size_t>(state.range(0));
    const bool campus = trees == 1233;
    if (campus && realData("utah_campus/utah_campus_trees.csv").empty()) {
        state.SkipWithError("no campus data; set OSGTREEWIND_DATA");
        return {};
    }
    const std::string name = campus ? "campus" : "thesis";
    auto forest = readForestFile(OSGTREEWIND_SOURCE_DIR "/examples/" + name + ".treewind");
    if (!forest) {
        state.SkipWithError(forest.problems().front().text().c_str());
        return {};
    }
    forest.value().law = MotionLaw::ThesisSmooth; // one of a branch
    forest.value().trees.resize(trees, forest.value().trees.front());
    for (std::size_t i = 0; i < trees && !campus; ++i) {
        forest.value().trees[i].position.x = 10.0 * static_cast<double>(i);
        forest.value().trees[i].seed = static_cast<std::uint32_t>(i);
    }
    return std::move(forest.value());
}

/// @param step takes the simulation on to a time.
template <typename Step>
void simulate(benchmark::State& state, Step step) {
    auto description = describe(state);
    if (!description)
        return;
    ForestSimulation simulation(std::move(*description));
    double time = 0.0;
    for (auto _ : state)
        benchmark::DoNotOptimize(step(simulation, time += frame));
    state.counters["units"] = static_cast<double>(movingForest(simulation).placed().units);
    state.counters["leaves"] = static_cast<double>(movingForest(simulation).placed().leaves);
}

/// The first half of a step: the wind at every branch base.
void sampleWind(benchmark::State& state) {
    simulate(state, [](ForestSimulation& simulation, double time) {
        return movingForest(simulation).beginStep(time);
    });
}

/// A whole step: wind, law, leaves, poses.
void advance(benchmark::State& state) {
    simulate(state, [](ForestSimulation& simulation, double time) { return simulation.advance(time); });
}

/// A step and the update traversal around it, under a branchwise law: textures, transforms and bounds.
void updateBranchwise(benchmark::State& state) {
    auto description = describe(state);
    if (!description)
        return;
    osg::ref_ptr<Forest> forest = new Forest(std::move(*description));
    osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    osgUtil::UpdateVisitor visitor;
    visitor.setFrameStamp(stamp);
    for (auto _ : state) {
        stamp->setFrameNumber(stamp->getFrameNumber() + 1);
        stamp->setSimulationTime(stamp->getSimulationTime() + frame);
        visitor.setTraversalNumber(stamp->getFrameNumber());
        forest->accept(visitor);
        osg::BoundingSphere bound = forest->getBound();
        benchmark::DoNotOptimize(bound);
    }
}

void trees(benchmark::internal::Benchmark* benchmark) {
    for (const int count : {1, 16, 1233})
        benchmark->Arg(count);
    benchmark->Unit(benchmark::kMillisecond)->Repetitions(5)->ReportAggregatesOnly();
}

} // namespace

BENCHMARK(sampleWind)->Apply(trees);
BENCHMARK(advance)->Apply(trees);
BENCHMARK(updateBranchwise)->Apply(trees);

BENCHMARK_MAIN();
