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
constexpr std::size_t campusTrees = 1233, nearEvery = 50;

/// Trees in rows. @param low, high metres of height.
ForestDescription madeForest(const std::vector<std::string>& species, std::size_t trees, float low,
                             float high) {
    ForestDescription forest;
    forest.wind = createSeries();
    for (const std::string& name : species) {
        forest.species.push_back(*findSpecies(name));
        forest.species.back().shapes = 3;
    }
    Random random(8);
    for (std::size_t i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.species = random.next() % species.size();
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

struct Running {
    BenchForest result;
    std::unique_ptr<ForestSimulation> simulation;

    Running(const std::string& name, ForestDescription description, Executor executor = {}) {
        result.name = name;
        result.law = description.law == MotionLaw::Modal ? "modal" : "damped";
        SimulationOptions options;
        options.leaves = false;
        options.executor = std::move(executor);
        const BenchClock clock;
        const std::clock_t before = std::clock();
        simulation = std::make_unique<ForestSimulation>(std::move(description), options);
        result.loadSeconds = clock.seconds();
        result.loadProcessorSeconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
        result.trees = SimulationParts::trees(*simulation).size();
        result.units = SimulationParts::forest(*simulation).units;
    }

    double milliseconds(double time) {
        const BenchClock clock;
        simulation->advance(time);
        return 1000.0 * clock.seconds();
    }
};

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
    return madeForest({"Norway spruce", "Scots pine", "beech", "oak", "silver birch"}, trees, 4.0f, 32.0f);
}

BenchForests runBenchForests(const std::optional<ForestDescription>& described, const std::string& file,
                             std::size_t trees, int rounds) {
    ForestDescription compared = described ? *described : madeForest({"broadleaf"}, campusTrees, 5.0f, 25.0f);
    compared.law = MotionLaw::Damped;
    ForestDescription wood = createWood(trees);
    wood.wind = compared.wind;

    BenchForests forests;
    const auto pool = std::make_shared<ThreadPool>();
    forests.threads = pool->threadCount();
    const auto oneCore = std::make_shared<bool>(false);
    const Executor executor = [=](std::size_t count, const std::function<void(std::size_t)>& job) {
        return *oneCore ? runInTurn(count, job) : pool->run(count, job);
    };
    Running damped(described ? file : "made trees", std::move(compared));
    Running modal("made trees", std::move(wood), executor);
    for (std::size_t i = 0; i < modal.result.trees; ++i)
        if (i % nearEvery == 0)
            ++modal.result.nearTrees;
        else
            SimulationParts::modal(*modal.simulation)->setLevel(i, ModalMotion::Level::Far);
    const ModalMotion& motion = *SimulationParts::modal(*modal.simulation);
    modal.result.archetypes = motion.archetypeCount();
    modal.result.archetypeBytes = motion.archetypeBytes();
    modal.result.stateBytesPerTree =
        static_cast<double>(motion.stateBytes()) / static_cast<double>(modal.result.trees);

    int step = 0;
    for (int round = -4; round < rounds; ++round) { // those before the first start trees and warm caches up
        const double ofDamped = damped.milliseconds(stepSeconds * round);
        double ofModal[2]; // on all cores, on one
        for (const int turn : {0, 1}) {
            const bool alone = (round + turn) % 2 != 0; // in either order: no two steps in a row are alike
            *oneCore = alone;
            ofModal[alone] = modal.milliseconds(stepSeconds * step++);
        }
        if (round < 0)
            continue;
        damped.result.stepMs.push_back(ofDamped);
        damped.result.oneCoreStepMs.push_back(ofDamped);
        modal.result.stepMs.push_back(ofModal[0]);
        modal.result.oneCoreStepMs.push_back(ofModal[1]);
    }
    forests.damped = std::move(damped.result);
    forests.modal = std::move(modal.result);
    return forests;
}
