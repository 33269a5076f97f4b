// SPDX-License-Identifier: MIT
#include <tests/motion/OneTree.h>

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace osgTreeWind;

TEST(ForestSteps, CalmAfterWindFreezesTheThesisLaw) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({2, 1, 0});
    ForestSimulation simulation(forest);
    run(simulation, 20);
    const auto poses = movingForest(simulation).branches()->poses();
    EXPECT_TRUE(simulation.setWind(nullptr).empty());
    run(simulation, 60, 1.0);
    EXPECT_GT(movingForest(simulation).branches()->states()[5].x, 0.01f);
    EXPECT_TRUE(sameBits(poses, movingForest(simulation).branches()->poses()));
}

TEST(ForestSteps, ThesisLawFollowsTheFrameRate) {
    ForestDescription forest = oneTree();
    forest.species[0].wood.elasticModulus = 2.0e8f; // stiff: far from the limit
    forest.wind = uniform({2, 0, 0});
    ForestSimulation slow(forest), fast(forest);
    run(slow, 30, 0.0, 1.0 / 30.0);
    run(fast, 60, 0.0, 1.0 / 60.0);
    EXPECT_NEAR(movingForest(fast).branches()->states()[8].x / movingForest(slow).branches()->states()[8].x,
                2.0f, 0.02f);
}

TEST(ForestSteps, AReplacedWindActsFromTheNextStep) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({1, 0, 0});
    ForestSimulation simulation(forest);
    run(simulation, 3);
    EXPECT_TRUE(simulation.setWind(uniform({0, -4, 0})).empty());
    simulation.advance(1.0);
    for (const glm::vec3& sample : movingForest(simulation).branches()->winds())
        EXPECT_EQ(sample, glm::vec3(0, -4, 0));
    EXPECT_TRUE(simulation.setWind(nullptr).empty());
    simulation.advance(1.1);
    EXPECT_EQ(movingForest(simulation).branches()->winds()[3], glm::vec3(0.0f));
}

TEST(ForestSteps, FirstCallPauseAndEarlierTimesKeepTheState) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({2, 0, 0});
    ForestSimulation simulation(forest);
    EXPECT_FALSE(simulation.advance(5.0));
    EXPECT_EQ(movingForest(simulation).branches()->states()[3], glm::vec4(0.0f));
    EXPECT_TRUE(simulation.advance(5.1));
    const auto states = movingForest(simulation).branches()->states();
    const auto leaves = movingForest(simulation).branches()->leafStates();
    EXPECT_FALSE(simulation.advance(5.1));
    EXPECT_FALSE(simulation.advance(2.0));
    EXPECT_FALSE(simulation.advance(std::nan("")));
    EXPECT_TRUE(sameBits(states, movingForest(simulation).branches()->states()));
    EXPECT_TRUE(sameBits(leaves, movingForest(simulation).branches()->leafStates()));
    EXPECT_TRUE(simulation.advance(2.1)); // continues from the earlier time
}

TEST(ForestSteps, AJumpIsOneStep) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({0.2f, 0, 0});
    ForestSimulation one(forest), jump(forest);
    run(one, 1);
    jump.advance(0.0);
    jump.advance(1.0e6);
    EXPECT_NEAR(movingForest(jump).branches()->states()[9].x, movingForest(one).branches()->states()[9].x,
                0.2f * movingForest(one).branches()->states()[9].x);
}

TEST(ForestSteps, GustsAreFollowedAtAnyFrameRate) {
    const auto tips = [](int rate) {
        ForestDescription forest = oneTree(MotionLaw::Modal);
        forest.species[0].wood.elasticModulus = 2.0e8f;
        forest.wind = std::make_shared<TestWind>([](const glm::vec3&, double t) {
            return glm::vec3(6.0 + 2.0 * std::sin(1.1 * t) + std::sin(2.7 * t + 1.0), std::sin(1.7 * t), 0.0);
        });
        ForestSimulation simulation(forest);
        std::vector<glm::vec3> path;
        for (int i = 0; i <= 10 * rate; ++i) {
            simulation.advance(static_cast<double>(i) / rate);
            if (i % (rate / 10) == 0)
                path.push_back(tip(simulation, 13));
        }
        return path;
    };
    const std::vector<glm::vec3> reference = tips(960);
    float peak = 0.0f;
    for (const glm::vec3& place : reference)
        peak = std::max(peak, glm::length(place - reference.front()));
    EXPECT_GT(peak, 0.05f);
    for (const auto& [rate, share] : {std::pair(30, 6e-3f), std::pair(120, 5e-4f)}) {
        const std::vector<glm::vec3> path = tips(rate);
        for (std::size_t i = 0; i < path.size(); ++i)
            ASSERT_LT(glm::length(path[i] - reference[i]), share * peak) << rate << " Hz, tenth " << i;
    }
}

TEST(ForestSteps, BelowTenFramesASecondTheMotionIsTheSame) {
    const auto path = [](int rate) { // positions of the outermost tip, one per second
        ForestDescription forest = oneTree(MotionLaw::Modal);
        forest.species[0].wood.elasticModulus = 2.0e8f;
        forest.trees[0].size = {9.0f, 0.1f, 0.0f};
        forest.wind = std::make_shared<TestWind>([](const glm::vec3&, double t) {
            return glm::vec3(6.0 + 2.0 * std::sin(1.1 * t) + std::sin(2.7 * t + 1.0), std::sin(1.7 * t), 0.0);
        });
        ForestSimulation simulation(forest);
        std::vector<glm::vec3> places;
        for (int i = 0; i <= 20 * rate; ++i) {
            simulation.advance(static_cast<double>(i) / rate);
            if (i % rate == 0)
                places.push_back(tip(simulation, 13));
        }
        return places;
    };
    const std::vector<glm::vec3> reference = path(60);
    float peak = 0.0f;
    for (const glm::vec3& place : reference)
        peak = std::max(peak, glm::length(place - reference.front()));
    EXPECT_GT(peak, 0.05f);
    for (const auto& [rate, share] : {std::pair(5, 0.04f), std::pair(2, 0.2f)}) {
        const std::vector<glm::vec3> slow = path(rate);
        for (std::size_t i = 0; i < slow.size(); ++i)
            EXPECT_LT(glm::length(slow[i] - reference[i]), share * peak) << rate << " Hz, second " << i;
    }
}

TEST(ForestSteps, UnderModalALongStepSamplesTheWindInBetween) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    std::vector<double> times;
    forest.wind = std::make_shared<TestWind>([&](const glm::vec3&, double t) {
        if (times.empty() || times.back() != t)
            times.push_back(t);
        return glm::vec3(3, 0, 0);
    });
    ForestSimulation simulation(forest);
    simulation.advance(2.0);
    times.clear();
    simulation.advance(2.05);
    EXPECT_EQ(times, std::vector<double>({2.05}));
    simulation.advance(2.45);
    ASSERT_EQ(times.size(), 5u);
    EXPECT_NEAR(times[1], 2.15, 1e-6);
    EXPECT_EQ(times[4], 2.45);
    times.clear();
    simulation.advance(1000.0);
    ASSERT_EQ(times.size(), 10u) << "a jump counts as a second";
    EXPECT_NEAR(times[0], 999.1, 1e-6);
}

TEST(ForestSteps, AReplacedWindIsInterpolatedWithinTheStep) {
    // From calm to 8 m/s within a long step: about half of the response to 8 m/s during the whole step.
    ForestDescription forest = oneTree(MotionLaw::Modal);
    ForestSimulation rising(forest), steady(forest);
    forest.wind = uniform({8, 0, 0});
    EXPECT_TRUE(steady.setWind(forest.wind).empty());
    for (ForestSimulation* simulation : {&rising, &steady})
        simulation->advance(0.0);
    EXPECT_TRUE(rising.setWind(forest.wind).empty());
    for (ForestSimulation* simulation : {&rising, &steady})
        simulation->advance(0.1);
    EXPECT_GT(movingForest(rising).modal()->lean(0).x, 0.0f);
    EXPECT_LT(movingForest(rising).modal()->lean(0).x, 0.5f * movingForest(steady).modal()->lean(0).x);
}

TEST(ForestSteps, UnderModalTheFrameRateDoesNotMatter) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.wind = uniform({4, 1, 0});
    ForestSimulation slow(forest), fast(forest);
    run(slow, 90, 0.0, 1.0 / 30.0);
    run(fast, 720, 0.0, 1.0 / 240.0);
    const float lean = tip(fast, 0).x - movingForest(fast).models()[0]->skeleton.units[0].tip.x;
    EXPECT_NEAR(tip(slow, 0).x, tip(fast, 0).x, 0.02f * lean);
}

TEST(ForestSteps, TinyStepsAddUp) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.wind = uniform({4, 0, 0});
    ForestSimulation usual(forest), fast(forest);
    const float upright = tip(usual, 1).x;
    run(usual, 100, 0.0, 0.01);
    run(fast, 10000, 0.0, 0.0001);
    const float bent = tip(usual, 1).x - upright;
    EXPECT_GT(std::abs(bent), 1e-3f);
    EXPECT_NEAR(tip(fast, 1).x - upright, bent, 0.03f * std::abs(bent));
}
