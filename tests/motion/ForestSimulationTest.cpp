// SPDX-License-Identifier: MIT
#include <tests/motion/OneTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

using namespace osgTreeWind;

namespace {

glm::vec3 turned(const glm::vec3& v, float heading) {
    return glm::angleAxis(heading, glm::vec3(0, 0, 1)) * v;
}

} // namespace

TEST(ForestSimulation, StartsAtRest) {
    const ForestSimulation simulation(oneTree());
    ASSERT_EQ(movingForest(simulation).branches()->poses().size(), 14u);
    ASSERT_EQ(movingForest(simulation).branches()->leafStates().size(), 24u);
    for (std::size_t unit = 0; unit < 14; ++unit)
        EXPECT_EQ(tip(simulation, unit), movingForest(simulation).models()[0]->skeleton.units[unit].tip);
}

TEST(ForestSimulation, CallsOnTreePlacedForEachTree) {
    for (const MotionLaw law : {MotionLaw::Thesis, MotionLaw::Modal}) {
        ForestDescription forest = oneTree(law);
        forest.trees.resize(5, forest.trees.front());
        int placed = 0;
        SimulationOptions options;
        options.onTreePlaced = [&] { ++placed; };
        const ForestSimulation simulation(forest, options);
        EXPECT_EQ(placed, 5);
    }
}

TEST(ForestSimulation, TipsMoveDownwind) {
    for (const MotionLaw law : {MotionLaw::Thesis, MotionLaw::ThesisSmooth, MotionLaw::Modal})
        for (const glm::vec3 wind : {glm::vec3(3, 0, 0), glm::vec3(0, 3, 0), glm::vec3(-2, 2, 0)}) {
            ForestDescription forest = oneTree(law);
            forest.wind = uniform(wind);
            ForestSimulation simulation(forest);
            std::vector<glm::vec3> rest;
            for (std::size_t unit = 0; unit < 14; ++unit)
                rest.push_back(tip(simulation, unit));
            run(simulation, law == MotionLaw::Modal ? 600 : 30); // the base first moves the other way
            for (std::size_t unit = 0; unit < 14; ++unit)
                EXPECT_GT(glm::dot(tip(simulation, unit) - rest[unit], wind), 0.0f) << "unit " << unit;
        }
}

TEST(ForestSimulation, JointsStayConnected) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({4, -3, 1});
    forest.trees[0].size = {11.0f, 0.5f, 9.0f};
    ForestSimulation simulation(forest);
    run(simulation, 100);
    const PlacedTree& tree = movingForest(simulation).trees()[0];
    const Skeleton& skeleton = movingForest(simulation).models()[tree.model]->skeleton;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const int parent = skeleton.units[i].parent;
        const glm::vec3 joint = tree.scale.axes * skeleton.units[i].base;
        const glm::vec3 below =
            parent < 0
                ? joint
                : movingForest(simulation).branches()->poses()[static_cast<std::size_t>(parent)].apply(joint);
        EXPECT_LT(glm::length(below - movingForest(simulation).branches()->poses()[i].apply(joint)), 1e-4f);
    }
}

TEST(ForestSimulation, AnglesStayWithinTheirLimits) {
    ForestDescription forest = oneTree();
    forest.species[0].branch.maxAngle = 0.3f;
    forest.wind = std::make_shared<TestWind>(
        [](const glm::vec3&, double t) { return glm::vec3(40 * std::sin(t), 40 * std::cos(3 * t), 0); });
    ForestSimulation simulation(forest);
    run(simulation, 300);
    for (const glm::vec4& state : movingForest(simulation).branches()->states()) {
        EXPECT_LE(std::abs(state.x), 0.3f);
        EXPECT_LE(std::abs(state.y), 0.3f);
    }
}

TEST(ForestSimulation, TreesComeToRestInCalm) {
    for (const char* name : {"broadleaf", "conifer"}) {
        ForestDescription forest;
        forest.species = {*findSpecies(name)};
        forest.trees.resize(1);
        forest.trees[0].size.height = 18.0f;
        forest.wind = uniform({12, 4, 0});
        ForestSimulation simulation(forest);
        const auto largestAngle = [&] {
            float largest = 0.0f;
            for (const glm::vec4& state : movingForest(simulation).motion(0).states)
                largest = std::max({largest, std::abs(state.x), std::abs(state.y)});
            return largest;
        };
        run(simulation, 600);
        EXPECT_GT(largestAngle(), 5e-3f) << name;
        EXPECT_TRUE(simulation.setWind(nullptr).empty());
        run(simulation, 60 * 90, 10.0);
        EXPECT_LT(largestAngle(), 1e-3f) << name << ", 90 s later";
    }
}

TEST(ForestSimulation, ARotatedTreeInARotatedWindHasTheRotatedPose) {
    const float heading = 0.8f;
    ForestDescription forest = oneTree();
    forest.wind = uniform({2, 0.5f, 0.1f});
    ForestSimulation straight(forest);
    forest.trees[0].heading = heading;
    forest.wind = uniform(turned({2, 0.5f, 0.1f}, heading));
    ForestSimulation other(forest);
    run(straight, 20);
    run(other, 20);
    for (std::size_t i = 0; i < 14; ++i) {
        EXPECT_LT(glm::length(tip(straight, i) - tip(other, i)), 1e-4f);
        EXPECT_LT(glm::length(turned(movingForest(straight).branches()->windPlaces()[i].position, heading) -
                              movingForest(other).branches()->windPlaces()[i].position),
                  1e-4f);
    }
}

TEST(ForestSimulation, SamplesTheWindAtEachBranchBase) {
    ForestDescription forest = oneTree();
    forest.origin = {448262.0, 4413000.0, 1600.0};
    forest.trees[0].position = forest.origin + glm::dvec3(100.25, -7.5, 2.0);
    forest.wind = std::make_shared<TestWind>(
        [](const glm::vec3& p, double t) { return p + glm::vec3(0, 0, static_cast<float>(t)); });
    ForestSimulation simulation(forest);
    simulation.advance(0.0);
    simulation.advance(2.0);
    const auto& units = movingForest(simulation).models()[0]->skeleton.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const glm::vec3 base = glm::vec3(100.25f, -7.5f, 2.0f) + units[i].base;
        EXPECT_LT(glm::length(movingForest(simulation).branches()->windPlaces()[i].position - base), 1e-4f);
        EXPECT_LT(glm::length(movingForest(simulation).branches()->winds()[i] - base - glm::vec3(0, 0, 2)),
                  1e-4f);
    }
}

TEST(ForestSimulation, WindDependsOnTheHeightAboveTheFootOfATree) {
    WindSeries series;
    series.times = {0.0};
    series.velocities = {{6.0f, 2.0f, 0.0f}};
    series.profile = LogProfile{10.0, 0.1};
    Wind gusts(std::make_shared<UniformWind>(glm::vec3(5.0f, 0.0f, 0.0f), series.profile));
    gusts.gusts.intensity = 0.2;
    for (const Wind& wind : {Wind(TimeSeriesWind::create(series).value()), gusts}) {
        ForestDescription forest = oneTree(MotionLaw::ThesisSmooth);
        forest.wind = wind;
        forest.trees.resize(3);
        forest.trees[1].position.z = 200.0;
        forest.trees[2].position.z = -50.0;
        ForestSimulation simulation(forest);
        simulation.advance(4.0);
        const std::vector<glm::vec3>& winds = movingForest(simulation).branches()->winds();
        const std::size_t units = winds.size() / 3;
        EXPECT_GT(glm::length(winds[units - 1]), 1.0f);
        for (std::size_t i = 0; i < units; ++i)
            for (std::size_t tree : {1u, 2u})
                EXPECT_LT(glm::length(winds[tree * units + i] - winds[i]), 1e-3f)
                    << "unit " << i << " of the tree at z = " << forest.trees[tree].position.z;
    }
}

TEST(ForestSimulation, StateContainsTheWindInTheTreesThesisAxes) {
    ForestDescription forest = oneTree();
    forest.trees[0].heading = 1.5707963f; // the tree's x points north
    forest.wind = uniform({3, 5, 0});
    ForestSimulation simulation(forest);
    run(simulation, 1);
    EXPECT_NEAR(movingForest(simulation).branches()->states()[0].z, 5.0f, 1e-5f); // north is the tree's x
    EXPECT_NEAR(movingForest(simulation).branches()->states()[0].w, 3.0f,
                1e-5f); // east is the tree's -y, thesis z
}

TEST(ForestSimulation, ResetReturnsToRest) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({2, 0, 0});
    ForestSimulation simulation(forest), fresh(forest);
    run(simulation, 20);
    simulation.reset();
    EXPECT_TRUE(
        sameBits(movingForest(simulation).branches()->poses(), movingForest(fresh).branches()->poses()));
    run(simulation, 20);
    run(fresh, 20);
    EXPECT_TRUE(
        sameBits(movingForest(simulation).branches()->states(), movingForest(fresh).branches()->states()));
    EXPECT_TRUE(sameBits(movingForest(simulation).branches()->leafStates(),
                         movingForest(fresh).branches()->leafStates()));
}

TEST(ForestSimulation, SameDescriptionAndTimesGiveTheSameBits) {
    ForestDescription forest = oneTree(MotionLaw::ThesisSmooth);
    forest.trees.resize(5);
    for (std::uint32_t i = 0; i < 5; ++i)
        forest.trees[i].seed = i;
    forest.wind = uniform({2, 1, 0});
    ForestSimulation a(forest), b(forest);
    run(a, 50);
    run(b, 50);
    EXPECT_TRUE(sameBits(movingForest(a).branches()->states(), movingForest(b).branches()->states()));
    EXPECT_TRUE(sameBits(movingForest(a).branches()->leafStates(), movingForest(b).branches()->leafStates()));
    EXPECT_TRUE(sameBits(movingForest(a).branches()->poses(), movingForest(b).branches()->poses()));
}

TEST(ForestSimulation, LeavesFlutterIndependently) {
    ForestDescription forest = oneTree();
    forest.trees.resize(2);
    forest.species[0].shapes = 3;
    forest.trees[1].seed = 3; // the same shape
    ForestSimulation simulation(forest);
    run(simulation, 30);
    const auto& leaves = movingForest(simulation).branches()->leafStates();
    EXPECT_EQ(movingForest(simulation).trees()[0].model, movingForest(simulation).trees()[1].model);
    EXPECT_NE(leaves[0].x, leaves[1].x);
    EXPECT_NE(leaves[0].x, leaves[movingForest(simulation).trees()[1].firstLeaf].x);
    EXPECT_NE(leaves[0].x, leaves[0].y);
}

TEST(ForestSimulation, LeavesMoveSmoothly) {
    ForestSimulation simulation(oneTree());
    run(simulation, 60);
    for (int frame = 61; frame < 400; ++frame) {
        const auto before = movingForest(simulation).branches()->leafStates();
        simulation.advance(frame / 60.0);
        for (std::size_t i = 0; i < before.size(); ++i)
            ASSERT_LT(std::abs(movingForest(simulation).branches()->leafStates()[i].x - before[i].x), 0.05f);
    }
}

TEST(ForestSimulation, ShapesAreSharedByTheTreesOfASpecies) {
    ForestDescription forest = oneTree();
    forest.species.push_back(forest.species[0]);
    forest.species[0].shapes = 2;
    forest.species[1].shapes = 4;
    forest.trees.resize(9);
    for (std::uint32_t i = 0; i < 9; ++i)
        forest.trees[i] = {i < 4 ? 0u : 1u, glm::dvec3(i), 0.0f, {}, 1.0f, i};
    const ForestSimulation simulation(forest);
    EXPECT_EQ(movingForest(simulation).models().size(), 6u);
    EXPECT_EQ(movingForest(simulation).trees()[3].model, 1u);
    EXPECT_EQ(movingForest(simulation).trees()[6].model, 2u + 6u % 4u);
    EXPECT_EQ(movingForest(simulation).trees()[8].firstUnit, 8u * 14u);
}

TEST(ForestSimulation, CreateReturnsTheProblems) {
    ForestDescription wrong;
    wrong.trees.emplace_back().species = 7;
    const auto refused = ForestSimulation::create(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.problems().front().key, "tree[0].species");
    const auto empty = ForestSimulation::create(ForestDescription());
    ASSERT_TRUE(empty);
    EXPECT_EQ(empty.value()->trees().size(), 0u);
    wrong.species.emplace_back();
    wrong.trees.front().species = 0;
    const auto one = ForestSimulation::create(wrong);
    ASSERT_TRUE(one);
    EXPECT_TRUE(one.value()->holds(TreeId(0)));
}

TEST(ForestSimulation, AnInvalidDescriptionMakesItEmptyWithAMessageToStderr) {
    ForestDescription forest = oneTree();
    forest.trees.resize(2);
    forest.trees[0].species = 7;
    testing::internal::CaptureStderr();
    const ForestSimulation simulation(forest);
    EXPECT_EQ(
        testing::internal::GetCapturedStderr(),
        "osgTreeWind: the forest is left empty: tree[0].species: there is no species 7; the forest has 1, "
        "from 0 on\n");
    EXPECT_EQ(simulation.trees().size(), 0u);
}

TEST(ForestSimulation, DescriptionHasNoTrees) {
    EXPECT_TRUE(ForestSimulation(oneTree()).description().trees.empty());
}

TEST(ForestSimulation, AnEmptyForestAdvances) {
    for (const MotionLaw law : {MotionLaw::ThesisSmooth, MotionLaw::Modal}) {
        ForestDescription none;
        none.law = law;
        ForestSimulation simulation(none);
        simulation.advance(0.0);
        EXPECT_TRUE(simulation.advance(1.0));
    }
}

TEST(ForestSimulation, RefusesAWindThatCheckRefuses) {
    ForestSimulation simulation(oneTree());
    Wind wind = uniform({3, 0, 0});
    EXPECT_TRUE(simulation.setWind(wind).empty());
    Wind bad = uniform({7, 0, 0});
    bad.frame = static_cast<WindFrame>(9);
    EXPECT_EQ(simulation.setWind(bad).size(), 1u);
    EXPECT_EQ(simulation.wind().field, wind.field);
}

TEST(ForestSimulation, RecoversFromAnInvalidWind) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({0.5f, 0, 0});
    ForestSimulation simulation(forest);
    run(simulation, 5);
    for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1e30f}) {
        EXPECT_TRUE(simulation.setWind(uniform(glm::vec3(bad))).empty());
        run(simulation, 3, 1.0);
        for (const UnitPose& pose : movingForest(simulation).branches()->poses())
            ASSERT_TRUE(std::isfinite(glm::length(pose.translation)) &&
                        std::isfinite(glm::length(pose.rotation)));
    }
    EXPECT_TRUE(simulation.setWind(uniform({-3, 0, 0})).empty());
    run(simulation, 200, 2.0);
    EXPECT_FLOAT_EQ(movingForest(simulation).branches()->states()[13].x, -0.5f);
}

TEST(ForestSimulation, WindMayBeReplacedFromAnotherThread) {
    ForestDescription forest = oneTree();
    forest.wind = uniform({1, 0, 0});
    ForestSimulation simulation(forest);
    std::atomic<bool> done{false};
    std::thread feeder([&] {
        for (int i = 0; !done; ++i)
            EXPECT_TRUE(simulation.setWind(uniform({static_cast<float>(i % 7), 2, 0})).empty());
    });
    for (int frame = 0; frame < 500; ++frame) {
        simulation.advance(frame / 60.0);
        const glm::vec3 first = movingForest(simulation).branches()->winds()[0];
        for (const glm::vec3& sample :
             movingForest(simulation).branches()->winds()) // a step uses one field for all branches
            ASSERT_EQ(sample, first);
    }
    done = true;
    feeder.join();
}

TEST(ForestSimulation, UnderModalComputesPosesOnRequest) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.wind = uniform({4, 0, 0});
    ForestSimulation simulation(forest);
    EXPECT_EQ(movingForest(simulation).branches(), nullptr);
    ASSERT_NE(movingForest(simulation).modal(), nullptr);
    run(simulation, 60);
    UnitValues values;
    const TreeMotion once = movingForest(simulation).motion(0),
                     again = movingForest(simulation).motion(0, values);
    ASSERT_EQ(once.poses.size, movingForest(simulation).models()[0]->skeleton.units.size());
    for (std::size_t unit = 0; unit < once.poses.size; ++unit) {
        EXPECT_EQ(once.states[unit], again.states[unit]);
        EXPECT_EQ(once.poses[unit].translation, again.poses[unit].translation);
        EXPECT_NEAR(once.winds[unit].x, 4.0f, 1e-5f);
    }
}

TEST(ForestSimulation, UnderModalTheValuesOfATreeStayInPlace) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.wind = uniform({4, 0, 0});
    ForestSimulation simulation(forest);
    const TreeMotion before = movingForest(simulation).motion(0);
    const glm::vec4 rest = before.states[0];
    run(simulation, 60);
    EXPECT_EQ(movingForest(simulation).motion(0).states.data, before.states.data);
    EXPECT_NE(before.states[0], rest);
}

TEST(ForestSimulation, WithoutLeavesHasNoLeafStates) {
    SimulationOptions options;
    options.leaves = false;
    ForestSimulation simulation(oneTree(MotionLaw::Modal), options);
    run(simulation, 2);
    EXPECT_EQ(movingForest(simulation).motion(0).leaves.size, 0u);
}

TEST(ForestSimulation, UnderModalAHostsThreadsDoTheWork) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.trees.resize(100, forest.trees.front());
    forest.wind = uniform({4, 0, 0});
    std::size_t jobs = 0;
    SimulationOptions options;
    options.executor = [&](std::size_t count, const std::function<void(std::size_t)>& job) {
        jobs += count;
        for (std::size_t i = count; i-- > 0;) // in any order
            job(i);
    };
    ForestSimulation lent(forest, options), own(forest);
    run(lent, 30);
    run(own, 30);
    EXPECT_GT(jobs, 30u);
    for (std::size_t tree = 0; tree < 100; ++tree)
        EXPECT_EQ(movingForest(lent).motion(tree).states[5], movingForest(own).motion(tree).states[5]);
}

TEST(ForestSimulation, UnderModalABareTreeSwaysLess) {
    ForestDescription forest = oneTree(MotionLaw::Modal);
    forest.wind = uniform({1, 0, 0});
    ForestSimulation leafy(forest);
    forest.trees[0].leaves = 0.0f;
    ForestSimulation bare(forest);
    run(leafy, 600);
    run(bare, 600);
    const float rest = movingForest(leafy).models()[0]->skeleton.units[1].tip.x;
    EXPECT_GT(tip(leafy, 1).x - rest, 1.5f * (tip(bare, 1).x - rest));
}
