// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchForests.h>

#include <examples/osgtreewind/bench/BenchClock.h>
#include <examples/osgtreewind/bench/BenchRows.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>

#include <cmath>
#include <ctime>
#include <memory>

using namespace osgTreeWind;

namespace {

constexpr double stepSeconds = 1.0 / 60.0;
constexpr std::size_t nearEvery = 50;

} // namespace

WindFieldPtr createSeries() {
    WindSeries series;
    for (int i = 0; i < 1000; ++i) {
        series.times.push_back(i);
        series.velocities.emplace_back(5.0 + std::sin(0.1 * i), std::cos(0.1 * i), 0.0);
    }
    series.profile = LogProfile{10.0, 0.5};
    return TimeSeriesWind::create(series).value();
}

ForestDescription createWood(std::size_t trees) {
    constexpr float low = 4.0f, high = 32.0f; // metres of height
    ForestDescription forest;
    forest.wind = createSeries();
    for (const char* name : {"Norway spruce", "Scots pine", "beech", "oak", "silver birch"}) {
        forest.species.push_back(*findSpecies(name));
        forest.species.back().shapes = 3;
    }
    Random random(8);
    for (std::size_t i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.species = random.next() % forest.species.size();
        tree.position = placeInRows(i, trees, 4.0);
        tree.heading = 6.28f * random.uniform();
        tree.seed = static_cast<std::uint32_t>(i);
        tree.size.height = low * std::pow(high / low, random.uniform());
        tree.size.trunkDiameter = tree.size.height * (0.017f + 0.022f * random.uniform()); // as on the campus
        tree.size.crownWidth = tree.size.height * (0.25f + 0.5f * random.uniform());
        forest.trees.push_back(tree);
    }
    return forest;
}

BenchForest runBenchForest(const std::optional<ForestDescription>& described, const std::string& file,
                           std::size_t trees, int rounds) {
    ForestDescription forest = described ? *described : createWood(trees);
    forest.law = MotionLaw::Modal;
    BenchForest result;
    result.name = described ? file : "made trees";
    const auto pool = std::make_shared<ThreadPool>();
    result.threads = pool->threadCount();
    const auto oneCore = std::make_shared<bool>(false);
    SimulationOptions options;
    options.leaves = false;
    options.executor = [=](std::size_t count, const std::function<void(std::size_t)>& job) {
        return *oneCore ? runInTurn(count, job) : pool->run(count, job);
    };
    const BenchClock loading;
    const std::clock_t before = std::clock();
    ForestSimulation simulation(std::move(forest), options);
    result.loadSeconds = loading.seconds();
    result.loadProcessorSeconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    result.trees = simulation.slotCount();
    result.units = SimulationParts::forest(simulation).units;
    ModalMotion& motion = *SimulationParts::modal(simulation);
    for (std::size_t i = 0; i < result.trees; ++i)
        if (i % nearEvery == 0)
            ++result.nearTrees;
        else
            motion.setLevel(i, ModalMotion::Level::Far);
    result.archetypes = motion.archetypeCount();
    result.archetypeBytes = motion.archetypeBytes();
    result.stateBytesPerTree = static_cast<double>(motion.stateBytes()) / static_cast<double>(result.trees);

    int step = 0;
    for (int round = -4; round < rounds; ++round) // those before the first start trees and warm caches up
        for (const int turn : {0, 1}) {
            *oneCore = (round + turn) % 2 != 0; // in either order
            const BenchClock clock;
            simulation.advance(stepSeconds * step++);
            if (round >= 0)
                (*oneCore ? result.oneCoreStepMs : result.stepMs).push_back(1000.0 * clock.seconds());
        }
    return result;
}
