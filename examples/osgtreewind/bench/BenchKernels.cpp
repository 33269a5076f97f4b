// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchKernels.h>

#include <examples/osgtreewind/bench/BenchClock.h>
#include <examples/osgtreewind/bench/BenchForests.h>
#include <examples/osgtreewind/bench/BenchStage.h>
#include <examples/osgtreewind/bench/BenchTrees.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/motion/CanopyOfTrees.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/branchwise/ThesisParts.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/StreamedWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindSampler.h>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace osgTreeWind;

namespace {

constexpr std::size_t branches = 4096, windSamples = 16384;

/// That many branches of broadleaves, 1 to 25 m high.
std::vector<Laws::ThesisBranch> someBranches() {
    ForestDescription forest;
    forest.law = MotionLaw::Thesis;
    forest.species = {defaultSpecies()};
    forest.trees.resize(40);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        forest.trees[i].seed = static_cast<std::uint32_t>(i);
        forest.trees[i].size.height = 1.0f + 0.6f * static_cast<float>(i);
    }
    const PlacedForest placed(std::move(forest));
    std::vector<Laws::ThesisBranch> result = BranchwiseMotion(placed).thesisBranches();
    result.resize(branches, result.front());
    return result;
}

std::vector<glm::vec3> someWinds() {
    Random random(1);
    std::vector<glm::vec3> winds(branches);
    for (glm::vec3& wind : winds)
        wind = {8.0f + 4.0f * random.symmetric(), 4.0f * random.symmetric(), 2.0f * random.symmetric()};
    return winds;
}

using ThesisStep = glm::vec4 (Laws::*)(glm::vec4, glm::vec3, glm::vec3, Laws::ThesisBranch);

TimedKernel thesisLaw(const char* name, ThesisStep step) {
    const std::vector<Laws::ThesisBranch> parameters = someBranches();
    std::vector<glm::vec4> states(branches, glm::vec4(0.0f));
    return {{"laws", name, "branch", branches, {}, 1}, [=, winds = someWinds()](double time) mutable {
                Laws laws;
                const NoiseTime now = NoiseTime::at(time, 0.7f);
                for (std::uint32_t i = 0; i < branches; ++i) {
                    glm::vec3 noise;
                    for (std::uint32_t axis = 0; axis < 3; ++axis)
                        noise[static_cast<int>(axis)] =
                            laws.motionNoise(laws.noiseStream(1, i, axis), now.cell, now.fraction, now.gain);
                    states[i] = (laws.*step)(states[i], winds[i], noise, parameters[i]);
                }
                kernelResult = states[7].x;
            }};
}

TimedKernel leafLaw(const char* name, std::optional<float> noiseExponent) {
    std::vector<glm::vec4> states(branches, glm::vec4(0.0f));
    return {{"laws", name, "leaf", branches, {}, 1}, [=](double time) mutable {
                Laws laws;
                const NoiseTime now = NoiseTime::at(time, 1.3f, noiseExponent);
                const Laws::ThesisLeaf leaf = makeThesisLeaf(LeafMotion());
                for (std::uint32_t i = 0; i < branches; ++i) {
                    const float x =
                        laws.motionNoise(laws.noiseStream(1, i, 3), now.cell, now.fraction, now.gain);
                    const float z =
                        laws.motionNoise(laws.noiseStream(1, i, 4), now.cell, now.fraction, now.gain);
                    states[i] = laws.thesisLeafStep(states[i], x, z, leaf);
                }
                kernelResult = states[7].x;
            }};
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
WindFieldPtr inAWood(const WindFieldPtr& gusts) {
    constexpr int rows = 260;
    CanopyTree tree;
    tree.height = 20.0f;
    tree.crownArea = 25.0f;
    tree.frontalArea = 50.0f;
    tree.drag.fill(2.0f);
    std::vector<CanopyTree> trees(rows * rows, tree);
    for (std::size_t i = 0; i < trees.size(); ++i)
        trees[i].place = {5.0f * static_cast<float>(i % rows), 5.0f * static_cast<float>(i / rows)};
    auto wood = std::make_shared<CanopyMap>(*canopyOf(trees));
    wood->refer(60.0f);
    return std::make_shared<WindSampler>(std::make_shared<Wind>(gusts), glm::dmat4(1.0), wood);
}

TimedKernel windKind(const char* name, const WindFieldPtr& field) {
    Random random(3);
    std::vector<WindPlace> places(windSamples);
    std::vector<glm::vec3> velocities(windSamples);
    glm::vec3 tree(0.0f);
    for (std::size_t i = 0; i < windSamples; ++i) { // trees of 128 branches, somewhere on the grid
        if (i % 128 == 0)
            tree = {1250.0f * random.uniform(), 1250.0f * random.uniform(), 0.0f};
        places[i] =
            tree + glm::vec3(10.0f * random.uniform(), 10.0f * random.uniform(), 20.0f * random.uniform());
        places[i].inCrown = true;
    }
    return {{"winds", name, "sample", windSamples, {}, 1}, [=](double time) mutable {
                field->sample(places.data(), windSamples, time, velocities.data());
                kernelResult = velocities[7].x;
            }};
}

std::vector<TimedKernel> allKernels() {
    GustWind::Parameters gusts;
    gusts.profile = LogProfile{10.0, 0.5};
    const WindFieldPtr turbulent = GustWind::create(gusts).value();
    const WindFieldPtr moving = GridWind::create(someGrid(8, 3)).value();
    auto carried = std::make_shared<Wind>(moving);
    carried->clock.speed = 8.0;
    std::vector<TimedKernel> kernels = {
        thesisLaw("thesis", &Laws::thesisBranchStep),
        thesisLaw("thesis-smooth", &Laws::thesisSmoothBranchStep),
        leafLaw("leaf, Perlin noise", {}),
        leafLaw("leaf, 1/f noise", 1.0f),
        windKind("uniform", std::make_shared<UniformWind>(glm::vec3(5.0f, 0.0f, 0.0f))),
        windKind("gusts", turbulent),
        windKind("gusts in a wood", inAWood(turbulent)),
        windKind("grid", GridWind::create(someGrid(1, 1)).value()),
        windKind("grid, 8 layers", GridWind::create(someGrid(8, 1)).value()),
        windKind("grid, 8 layers, 3 times", moving),
        windKind("forest_wind", BenchWinds().at(0)),
        windKind("series", createSeries()),
        windKind("travelling (.bts)", std::make_shared<WindSampler>(carried)),
        windKind("streamed", StreamedWind::create(someGrid(8, 1)).value()),
        windKind("callable", std::make_shared<FunctionWind>([](const glm::vec3& p, double) {
                     return glm::vec3(0.01f * p.y, 5.0f, 0.0f);
                 }))};
    std::vector<TimedKernel> trees = treeKernels();
    kernels.insert(kernels.begin() + 3, std::make_move_iterator(trees.begin()),
                   std::make_move_iterator(trees.end()));
    return kernels;
}

} // namespace

std::vector<BenchKernel> runBenchKernels(const std::vector<std::string>& groups, int rounds) {
    if (groups.empty())
        return {};
    std::vector<TimedKernel> kernels = allKernels();
    kernels.erase(std::remove_if(kernels.begin(), kernels.end(),
                                 [&](const TimedKernel& t) {
                                     return std::find(groups.begin(), groups.end(), t.kernel.group) ==
                                            groups.end();
                                 }),
                  kernels.end());
    for (int round = -1; round < rounds; ++round) // the first one warms caches up
        for (TimedKernel& timed : kernels) {
            const BenchClock clock;
            timed.round(static_cast<double>(round + 1) * static_cast<double>(kernelStep));
            const double taken = clock.seconds();
            if (round >= 0)
                timed.kernel.nanoseconds.push_back(1e9 * taken / static_cast<double>(timed.kernel.elements));
        }
    std::vector<BenchKernel> results;
    for (TimedKernel& timed : kernels)
        results.push_back(std::move(timed.kernel));
    return results;
}
