// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/ForestStorm.h>

#include <examples/osgtreewind/storm/StormTree.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/wind/LogProfile.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

const glm::vec3 toEast(1.0f, 0.0f, 0.0f);

constexpr int rows = 17;

/// Spruces of 24 cm and 20 m: rows 2.5 m apart, and one alone to the west of them.
ForestDescription wood() {
    ForestDescription forest;
    forest.species = {*findSpecies("Sitka spruce")};
    TreePlacement tree;
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.24f;
    tree.position = {-300.0, 20.0, 0.0};
    forest.trees.push_back(tree);
    for (int i = 0; i < rows * rows; ++i) {
        tree.position = {2.5 * (i % rows), 2.5 * (i / rows), 0.0};
        forest.trees.push_back(tree);
    }
    return forest;
}

constexpr std::size_t alone = 0, windward = 1 + rows * (rows / 2), leeward = windward + rows - 1;

/// Moments at the feet of all trees.
std::vector<double> feetOf(const std::vector<ForestStorm::Loads>& loads) {
    std::vector<double> moments;
    for (const ForestStorm::Loads& tree : loads)
        moments.push_back(tree.foot);
    return moments;
}

} // namespace

TEST(ForestStorm, ADenseWoodSheltersItsTrees) {
    const PlacedForest forest(wood());
    const std::vector<double> moments = feetOf(ForestStorm(forest, toEast, runInTurn).largestLoads(20.0, 1));
    ASSERT_EQ(moments.size(), 1u + rows * rows);
    EXPECT_GT(moments[leeward], 1e3);
    EXPECT_GT(moments[windward], 1.2 * moments[leeward]);
    EXPECT_GT(moments[alone], 1.2 * moments[leeward]);
}

TEST(ForestStorm, DoesNotDependOnThreadsAndSkipsRemovedTrees) {
    ForestDescription few = wood();
    few.trees.resize(4);
    PlacedForest forest(few);
    forest.remove(2);
    const auto moments = [&](const Executor& executor) {
        return feetOf(ForestStorm(forest, toEast, executor).largestLoads(15.0, 1));
    };
    const std::vector<double> one = moments(runInTurn);
    EXPECT_EQ(one, moments(ThreadPool::executor(3)));
    EXPECT_EQ(one[2], 0.0);
    EXPECT_GT(one[1], 0.0);
}

TEST(ForestStorm, GivesTheWindAtTheTopOfTrees) {
    const PlacedForest forest(wood());
    const std::vector<float> winds = ForestStorm(forest, toEast, runInTurn).topWinds();
    EXPECT_NEAR(winds[alone], LogProfile({10.0, 0.03}).factor(20.0), 0.01);
    EXPECT_LT(winds[leeward], winds[alone]);
}

/// The largest moment of an hour, in the mean of some hours, by the two ways to compute it: 8 trees with four
/// modes in a forest, and one tree with all its modes in a stand without end.
TEST(ForestStorm, AgreesWithOneTreeInAStand) {
    constexpr double spacing = 2.8, top = 10.0; // metres, m/s
    ForestDescription stand = wood();
    stand.trees.resize(8);
    for (std::size_t i = 0; i < stand.trees.size(); ++i)
        stand.trees[i].position = {60.0 * static_cast<double>(i % 2), 60.0 * static_cast<double>(i / 2), 0.0};
    stand.canopy.source = CanopySource::Given;
    PlacedForest forest(stand);
    const CanopyTree crown(forest, forest.trees.front());
    stand.canopy.height = static_cast<double>(crown.height);
    stand.canopy.frontalArea = static_cast<double>(crown.frontalArea) / (spacing * spacing);
    forest = PlacedForest(stand);
    const ForestStorm storm(forest, toEast, ThreadPool::executor());
    const double speed = top / static_cast<double>(storm.topWinds().front());
    double inForest = 0.0, single = 0.0;
    constexpr std::uint32_t hours = 5;
    for (std::uint32_t seed = 1; seed <= hours; ++seed)
        for (const double moment : feetOf(storm.largestLoads(speed, seed)))
            inForest += moment / (8.0 * hours);
    for (std::uint32_t seed = 1; seed <= hours; ++seed) {
        StormTree tree(stand.species.front(), stand.trees.front(), {top, spacing, seed});
        (void)tree.advance(60.0);
        single += tree.largestMoment(3660.0) / hours;
    }
    EXPECT_NEAR(inForest / single, 1.0, 0.1);
}

} // namespace osgTreeWind
