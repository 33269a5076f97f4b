// SPDX-License-Identifier: MIT
// What one branch, leaf or tree of a law and one sample of each kind of wind cost, and a step of a whole
// wood, without graphics and leaves.
#include <examples/osgtreewind/bench/BenchWood.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/branchwise/ThesisParameters.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/LayeredWind.h>
#include <osgTreeWind/wind/StreamedWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <benchmark/benchmark.h>

#include <cstring>
#include <iterator>

using namespace osgTreeWind;

namespace {

constexpr std::size_t branches = 4096, windSamples = 16384, modalTrees = 4096, posedTrees = 64;
constexpr float step = 1.0f / 60.0f;

/// Measures rounds of that many elements. @param round given the time, seconds.
template <typename Round>
void measure(benchmark::State& state, std::size_t elements, Round round) {
    double time = 0.0;
    for (auto _ : state)
        benchmark::DoNotOptimize(round(time += static_cast<double>(step)));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * elements));
}

using ThesisStep = glm::vec4 (Laws::*)(glm::vec4, glm::vec3, glm::vec3, Laws::ThesisBranch);

/// Branches of broadleaves, 1 to 25 m high.
void thesisLaw(benchmark::State& state, MotionLaw law, ThesisStep branchStep) {
    ForestDescription forest;
    forest.law = law;
    forest.species = {defaultSpecies()};
    forest.trees.resize(40);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        forest.trees[i].seed = static_cast<std::uint32_t>(i);
        forest.trees[i].size.height = 1.0f + 0.6f * static_cast<float>(i);
    }
    const PlacedForest placed(std::move(forest));
    std::vector<Laws::ThesisBranch> parameters = BranchwiseMotion(placed).thesisBranches();
    parameters.resize(branches, parameters.front());
    Random random(1);
    std::vector<glm::vec3> winds(branches);
    for (glm::vec3& wind : winds)
        wind = {8.0f + 4.0f * random.symmetric(), 4.0f * random.symmetric(), 2.0f * random.symmetric()};
    std::vector<glm::vec4> states(branches, glm::vec4(0.0f));
    Laws laws;
    measure(state, branches, [&](double time) {
        const NoiseTime now = NoiseTime::at(time, 0.7f);
        for (std::uint32_t i = 0; i < branches; ++i) {
            glm::vec3 noise;
            for (std::uint32_t axis = 0; axis < 3; ++axis)
                noise[static_cast<int>(axis)] =
                    laws.motionNoise(laws.noiseStream(1, i, axis), now.cell, now.fraction, now.gain);
            states[i] = (laws.*branchStep)(states[i], winds[i], noise, parameters[i]);
        }
        return states[7].x;
    });
}

void leaves(benchmark::State& state, std::optional<float> noiseExponent) {
    std::vector<glm::vec4> states(branches, glm::vec4(0.0f));
    Laws laws;
    const Laws::ThesisLeaf leaf = makeThesisLeaf(LeafMotion());
    measure(state, branches, [&](double time) {
        const NoiseTime now = NoiseTime::at(time, 1.3f, noiseExponent);
        for (std::uint32_t i = 0; i < branches; ++i) {
            const float x = laws.motionNoise(laws.noiseStream(1, i, 3), now.cell, now.fraction, now.gain);
            const float z = laws.motionNoise(laws.noiseStream(1, i, 4), now.cell, now.fraction, now.gain);
            states[i] = laws.thesisLeafStep(states[i], x, z, leaf);
        }
        return states[7].x;
    });
}

Wind gusty(WindFieldPtr field) {
    Wind wind(std::move(field));
    wind.gusts.intensity = 0.2;
    return wind;
}

Wind gusts() {
    return gusty(std::make_shared<UniformWind>(glm::vec3(5.0f, 0.0f, 0.0f), LogProfile{10.0, 0.5}));
}

/// 64 x 64 points, 20 m apart. @param layers upward. @param times 1 or more, a minute apart.
GridWind::Grid someGrid(int layers, int times) {
    GridWind::Grid grid;
    grid.points = {64, 64, layers};
    grid.cell = {20.0, 20.0, 10.0};
    for (int i = 0; i < times && times > 1; ++i)
        grid.times.push_back(60.0 * i);
    Random random(2);
    grid.values.resize(static_cast<std::size_t>(3 * 64 * 64 * layers * times));
    for (float& value : grid.values)
        value = 8.0f * random.symmetric();
    return grid;
}

/// Gusts among trees of 20 m, 5 m apart as far as they are sampled.
WindFieldPtr gustsInAWood() {
    constexpr int rows = 260;
    CanopyTree tree;
    tree.height = 20.0f;
    tree.crownArea = 25.0f;
    tree.frontalArea = 50.0f;
    tree.drag.fill(2.0f);
    std::vector<CanopyTree> trees(rows * rows, tree);
    for (std::size_t i = 0; i < trees.size(); ++i)
        trees[i].place = {5.0f * static_cast<float>(i % rows), 5.0f * static_cast<float>(i / rows)};
    const std::shared_ptr<CanopyMap> wood = makeCanopyMap(trees);
    wood->setReference(60.0f);
    return std::make_shared<LayeredWind>(std::make_shared<Wind>(gusts()), glm::dmat4(1.0), wood);
}

/// Samples in groups of 128 within a tree, over 1.3 km.
void sample(benchmark::State& state, const WindFieldPtr& field) {
    Random random(3);
    std::vector<WindPlace> places(windSamples);
    std::vector<PlaceInStand> stands(windSamples);
    std::vector<glm::vec3> velocities(windSamples);
    glm::vec3 tree(0.0f);
    for (std::size_t i = 0; i < windSamples; ++i) {
        if (i % 128 == 0)
            tree = {1250.0f * random.uniform(), 1250.0f * random.uniform(), 0.0f};
        places[i] =
            tree + glm::vec3(10.0f * random.uniform(), 10.0f * random.uniform(), 20.0f * random.uniform());
        places[i].inCrown = true;
        places[i].stand = &stands[i]; // as for the patches of trees
    }
    measure(state, windSamples, [&](double time) {
        field->sample(places.data(), windSamples, time, velocities.data());
        return velocities[7].x;
    });
}

/// Reference trees in rows, 6 m apart, under `modal`, in motion.
std::unique_ptr<ForestSimulation> swayingTrees(std::size_t count, unsigned threads) {
    ForestDescription forest;
    forest.species.emplace_back();
    forest.species.front().shapes = 1;
    forest.trees.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        forest.trees[i].position = placeInRows(i, count, 6.0);
        forest.trees[i].heading = static_cast<float>(i);
    }
    SimulationOptions options;
    options.leaves = false;
    options.executor = threads > 1 ? ThreadPool::executor(threads) : Executor(runInTurn);
    auto simulation = std::make_unique<ForestSimulation>(std::move(forest), options);
    EXPECT_TRUE(simulation->setWind(gusts()).empty());
    for (int i = -30; i < 0; ++i)
        simulation->advance(static_cast<double>(i) * static_cast<double>(step));
    return simulation;
}

/// All that a simulation does in a step; no poses.
void modalTree(benchmark::State& state, bool calm, unsigned threads) {
    const auto simulation = swayingTrees(modalTrees, threads);
    if (calm) {
        EXPECT_TRUE(simulation->setWind(nullptr).empty());
    }
    measure(state, modalTrees, [&](double time) { return simulation->advance(time); });
}

/// What it takes to show a tree.
void modalPoses(benchmark::State& state) {
    const auto simulation = swayingTrees(posedTrees, 1);
    UnitValues values;
    measure(state, posedTrees, [&](double) {
        float result = 0.0f;
        for (std::size_t i = 0; i < posedTrees; ++i)
            result = movingForest(*simulation).motion(i, values).states[7].x;
        return result;
    });
}

/// The law by itself, in a wind that is there.
void modalStep(benchmark::State& state, InstructionSet set) {
    if (set > bestInstructionSet())
        return state.SkipWithError("this processor has no such instructions");
    ForestDescription one;
    one.species.emplace_back();
    one.species.front().shapes = 1;
    one.trees.resize(1);
    const PlacedForest forest(std::move(one));
    const Archetype archetype(
        TreeForm{forest.models().front().get(), &forest.description().species.front(), {}, 1.0f});
    const ModalModel& model = archetype.model(0);
    const std::size_t floats = treeFloats(model);
    float factors[sizeof(TreeFactors) / sizeof(float)];
    const TreeFactors asItIs;
    std::memcpy(factors, &asItIs, sizeof factors);
    std::vector<TreeLanes> trees(modalTrees / TreeLanes::count * floats);
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (const std::size_t behind = floats - i % floats; behind <= std::size(factors))
            std::fill_n(trees[i].tree, TreeLanes::count, factors[std::size(factors) - behind]);
    std::vector<TreeLanes> wind(3 * model.patches.size());
    for (std::size_t i = 0; i < wind.size(); i += 3)
        std::fill_n(wind[i].tree, TreeLanes::count, 8.0f);
    measure(state, modalTrees, [&](double) {
        for (std::size_t i = 0; i < trees.size(); i += floats)
            stepTrees({&model, &trees[i], wind.data(), step, 1, 1.0f}, set);
        return trees[0].tree[0];
    });
}

/// A step of a wood, one tree in fifty near. The arguments are the number of trees, and 1 for a single core.
void wood(benchmark::State& state) {
    SimulationOptions options;
    options.leaves = false;
    if (state.range(1) == 1)
        options.executor = runInTurn;
    ForestSimulation simulation(createWood(static_cast<std::size_t>(state.range(0))), options);
    ModalMotion& motion = *movingForest(simulation).modal();
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i)
        if (i % 50 != 0)
            motion.setLevel(i, ModalMotion::Level::Far);
    measure(state, static_cast<std::size_t>(state.range(0)),
            [&](double time) { return simulation.advance(time); });
    state.counters["archetypes"] = static_cast<double>(motion.archetypeCount());
    state.counters["archetypeBytes"] = static_cast<double>(motion.archetypeBytes());
    state.counters["stateBytesPerTree"] =
        static_cast<double>(motion.stateBytes()) / static_cast<double>(state.range(0));
}

/// A step of 1,000 trees beside each of which something moves the air. The argument is the number of sources.
void woodAmongSources(benchmark::State& state) {
    constexpr std::size_t trees = 1000;
    const auto sources = static_cast<std::size_t>(state.range(0));
    ForestDescription description = createWood(trees);
    for (std::size_t i = 0; i < sources; ++i) {
        WindSource source;
        source.kind = static_cast<WindSource::Kind>(i % 6);
        source.position = description.trees[i * trees / sources].position + glm::dvec3(3.0, 4.0, 8.0);
        source.velocity.x = i % 2 == 0 ? 10.0 : 0.0;
        source.thrust = 200.0; // a drone
        source.dragArea = 0.7; // a car
        source.height = 1.5;
        source.radius = 1.0;
        source.charge = 0.1;
        source.time = 1.0;
        description.wind.sources.push_back(source);
    }
    SimulationOptions options;
    options.leaves = false;
    ForestSimulation simulation(std::move(description), options);
    measure(state, trees, [&](double time) { return simulation.advance(time); });
}

} // namespace

BENCHMARK_CAPTURE(thesisLaw, thesis, MotionLaw::Thesis, &Laws::thesisBranchStep);
BENCHMARK_CAPTURE(thesisLaw, smooth, MotionLaw::ThesisSmooth, &Laws::thesisSmoothBranchStep);
BENCHMARK_CAPTURE(leaves, perlin, std::nullopt);
BENCHMARK_CAPTURE(leaves, oneOverF, 1.0f);
BENCHMARK_CAPTURE(modalTree, calm, true, 1);
BENCHMARK_CAPTURE(modalTree, gusts, false, 1);
BENCHMARK_CAPTURE(modalTree, gustsOnAllCores, false, ThreadPool().threadCount())->UseRealTime();
BENCHMARK(modalPoses);
BENCHMARK_CAPTURE(modalStep, baseline, InstructionSet::Baseline);
BENCHMARK_CAPTURE(modalStep, avx2, InstructionSet::Avx2);
BENCHMARK_CAPTURE(modalStep, avx512, InstructionSet::Avx512);
BENCHMARK(wood)->Args({100000, 0})->Args({100000, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(woodAmongSources)->Arg(1)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(sample, uniform, std::make_shared<UniformWind>(glm::vec3(5.0f, 0.0f, 0.0f)));
BENCHMARK_CAPTURE(sample, gusts, asField(gusts()));
BENCHMARK_CAPTURE(sample, gustsOverAGrid, asField(gusty(GridWind::create(someGrid(1, 1)).value())));
BENCHMARK_CAPTURE(sample, gustsInAWood, gustsInAWood());
BENCHMARK_CAPTURE(sample, grid, GridWind::create(someGrid(1, 1)).value());
BENCHMARK_CAPTURE(sample, gridOf8Layers, GridWind::create(someGrid(8, 1)).value());
BENCHMARK_CAPTURE(sample, gridOf8LayersAnd3Times, GridWind::create(someGrid(8, 3)).value());
BENCHMARK_CAPTURE(sample, series, createSeries());
BENCHMARK_CAPTURE(sample, streamed, StreamedWind::create(someGrid(8, 1)).value());
BENCHMARK_CAPTURE(sample, callable, std::make_shared<FunctionWind>([](const glm::vec3& place, double) {
                      return glm::vec3(0.01f * place.y, 5.0f, 0.0f);
                  }));
