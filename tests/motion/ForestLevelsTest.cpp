// SPDX-License-Identifier: MIT
// Near and far trees of a forest.
#include <tests/motion/OneTree.h>
#include <tests/motion/Sapling.h>

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

ForestDescription saplings(std::size_t count) {
    ForestDescription forest;
    forest.species = {sapling()};
    forest.trees.resize(count);
    return forest;
}

} // namespace

TEST(ForestLevels, FarTreesTakeLessMemory) {
    ForestDescription forest = saplings(2000);
    SimulationOptions options;
    options.leaves = false;
    ForestSimulation simulation(std::move(forest), options);
    const auto bytesPerTree = [&] {
        return movingForest(simulation).modal()->stateBytes() / movingForest(simulation).trees().size();
    };
    EXPECT_LE(bytesPerTree(), 300u);
    for (std::size_t i = 0; i < movingForest(simulation).trees().size(); ++i)
        movingForest(simulation)
            .modal()
            ->setLevel(i, i % 50 == 0 ? ModalMotion::Level::Near : ModalMotion::Level::Far);
    EXPECT_LE(bytesPerTree(), 200u);
}

TEST(ForestLevels, ATreeThatComesNearKeepsItsModes) {
    ForestDescription forest = saplings(3);
    forest.wind = std::make_shared<UniformWind>(glm::vec3(8.0f, 2.0f, 0.0f));
    ForestSimulation simulation(std::move(forest));
    for (const auto level : {ModalMotion::Level::Far, ModalMotion::Level::Near}) {
        movingForest(simulation).modal()->setLevel(2, level);
        run(simulation, 30, level == ModalMotion::Level::Far ? 0.0 : 1.0);
    }
    movingForest(simulation).modal()->setLevel(2, ModalMotion::Level::Far);
    run(simulation, 30, 2.0); // with the other near trees of its block
    const std::vector<float> far = movingForest(simulation).modal()->amplitudes(2);
    movingForest(simulation).modal()->setLevel(2, ModalMotion::Level::Near);
    const std::vector<float> near = movingForest(simulation).modal()->amplitudes(2);
    ASSERT_GT(near.size(), far.size());
    for (std::size_t k = 0; k < far.size(); ++k)
        EXPECT_EQ(near[k], far[k]) << k;
    run(simulation, 30, 3.0);
    for (const float amplitude : movingForest(simulation).modal()->amplitudes(2))
        EXPECT_TRUE(std::isfinite(amplitude));
}
