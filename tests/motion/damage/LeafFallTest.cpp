// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/LeafFall.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

WindFieldPtr westerly(float speed) {
    return std::make_shared<UniformWind>(glm::vec3(speed, 0.0f, 0.0f));
}

ForestDescription wood(const char* species, float speed, float season = midautumn) {
    ForestDescription forest;
    forest.species = {*findSpecies(species)};
    forest.season = season;
    for (int i = 0; i < 3; ++i) {
        TreePlacement tree;
        tree.position = {40.0 * i, 0.0, 0.0};
        tree.heading = 0.9f * static_cast<float>(i);
        tree.size.height = 12.0f;
        forest.trees.push_back(tree);
    }
    forest.wind = westerly(speed);
    forest.damage = true;
    return forest;
}

/// @return share of leaves of the first tree at `to`.
float leavesAfter(ForestSimulation& forest, double from, double to) {
    for (double time = from; time <= to; time += 0.05)
        forest.advance(time);
    return movingForest(forest).trees()[0].leaves;
}

} // namespace

TEST(LeafFall, FollowsTheDragOfLooseLeaves) {
    Species stiff;
    stiff.wood.streamlining = stiff.wood.breezeStreamlining = 0.0f;
    const LeafFall leaves(stiff);
    EXPECT_EQ(leaves.seasonAdvance(0.0f), 0.0f);
    EXPECT_NEAR(leaves.seasonAdvance(16.5f), 0.25f * LeafFall::maxAdvance, 1e-6f)
        << "half the speed, a quarter of the force";
    EXPECT_FLOAT_EQ(leaves.seasonAdvance(33.0f), LeafFall::maxAdvance);
    EXPECT_FLOAT_EQ(leaves.seasonAdvance(90.0f), LeafFall::maxAdvance);
    EXPECT_FLOAT_EQ(LeafFall::maxAdvance * 365.25f / 4.0f, 14.0f) << "days";
    const Species birch = *findSpecies("silver birch");
    EXPECT_GT(LeafFall(birch).seasonAdvance(16.5f), 0.28f * LeafFall::maxAdvance)
        << "birch leaves streamline in stronger winds";
}

TEST(LeafFall, TakesLeavesThatWouldFallSoonAndOnlyInAutumn) {
    const Species birch = *findSpecies("silver birch"), spruce = *findSpecies("Norway spruce");
    const LeafFall leaves(birch);
    EXPECT_EQ(leaves.remainingShare(midautumn, 0.1f), leafShare(birch.appearance, midautumn + 0.1f));
    EXPECT_LT(leaves.remainingShare(midautumn, 0.1f), leafShare(birch.appearance, midautumn) - 0.15f);
    for (const float season : {midwinter, midspring, 1.1f, midsummer, 2.4f, 3.9f}) {
        EXPECT_FALSE(leaves.hasLooseLeaves(season)) << season;
        EXPECT_EQ(leaves.remainingShare(season, LeafFall::maxAdvance), leafShare(birch.appearance, season))
            << season;
    }
    EXPECT_TRUE(leaves.hasLooseLeaves(midautumn));
    EXPECT_FALSE(LeafFall(spruce).hasLooseLeaves(midautumn));
}

TEST(LeafFall, LeavesStayOffAfterAGust) {
    ForestDescription description = wood("silver birch", 0.0f);
    description.wind = std::make_shared<FunctionWind>([](const glm::vec3&, double time) {
        return glm::vec3(time > 4.0 && time < 5.0 ? 15.0f : 3.0f, 0.0f, 0.0f);
    });
    ForestSimulation forest(description);
    const LeafFall leaves(description.species[0]);
    const float before = leavesAfter(forest, 0.0, 3.0);
    EXPECT_NEAR(before, leaves.remainingShare(midautumn, leaves.seasonAdvance(3.0f)), 1e-4f);
    EXPECT_NEAR(leavesAfter(forest, 3.05, 8.0), leaves.remainingShare(midautumn, leaves.seasonAdvance(15.0f)),
                1e-4f);
    EXPECT_LT(movingForest(forest).trees()[0].leaves, before - 0.05f);
    EXPECT_GT(movingForest(forest).trees()[0].leaves, 0.1f);
}

TEST(LeafFall, TheTreeSwaysWithItsRemainingLeaves) {
    ForestSimulation shed(wood("silver birch", 28.0f));
    const float left = leavesAfter(shed, 0.0, 10.0);
    ForestDescription description = wood("silver birch", 28.0f);
    description.damage = false;
    for (TreePlacement& tree : description.trees)
        tree.leaves = left / leafShare(description.species[0].appearance, midautumn);
    ForestSimulation thinned(description);
    leavesAfter(thinned, 0.0, 10.0);
    ASSERT_NEAR(movingForest(thinned).trees()[0].leaves, left, 1e-5f);
    ForestDescription full = wood("silver birch", 28.0f);
    full.damage = false;
    ForestSimulation unshed(full);
    leavesAfter(unshed, 0.0, 10.0);
    for (ForestSimulation* each : {&shed, &thinned, &unshed}) {
        EXPECT_TRUE(each->setWind(westerly(10.0f)).empty());
        leavesAfter(*each, 10.05, 60.0);
    }
    const float lean = movingForest(thinned).modal()->lean(0).x;
    EXPECT_NEAR(movingForest(shed).modal()->lean(0).x, lean, 0.01f * lean);
    EXPECT_GT(movingForest(unshed).modal()->lean(0).x, 1.05f * lean);
}

TEST(LeafFall, DoesNotOccurWithoutDamageInSummerOrOnEvergreens) {
    ForestDescription calm = wood("silver birch", 15.0f);
    calm.damage = false;
    ForestSimulation off(calm), summer(wood("silver birch", 15.0f, midsummer)),
        spruce(wood("Norway spruce", 15.0f));
    EXPECT_EQ(leavesAfter(off, 0.0, 3.0), leafShare(calm.species[0].appearance, midautumn));
    EXPECT_EQ(leavesAfter(summer, 0.0, 3.0), 1.0f);
    EXPECT_EQ(leavesAfter(spruce, 0.0, 3.0), 1.0f);
}

TEST(LeafFall, LastsThroughAutumnAndIsResetInSummer) {
    const ForestDescription description = wood("silver birch", 15.0f);
    const Appearance& birch = description.species[0].appearance;
    ForestSimulation forest(description);
    const float shed = leavesAfter(forest, 0.0, 3.0);
    EXPECT_LT(shed, leafShare(birch, midautumn) - 0.05f);
    EXPECT_TRUE(forest.setWind(nullptr).empty());
    EXPECT_TRUE(forest.setSeason(midautumn - 0.05f)
                    .empty()); // an earlier season restores only the leaves of that season
    EXPECT_LT(leavesAfter(forest, 3.05, 4.0), leafShare(birch, midautumn - 0.05f));
    EXPECT_TRUE(forest.setSeason(midsummer - 0.5f).empty());
    EXPECT_EQ(leavesAfter(forest, 4.05, 5.0), leafShare(birch, midsummer - 0.5f));
    EXPECT_TRUE(forest.setSeason(midautumn).empty());
    EXPECT_EQ(leavesAfter(forest, 5.05, 6.0), leafShare(birch, midautumn));
}

TEST(LeafFall, ResetCopiesAndReplacedTreesHaveAllLeaves) {
    const ForestDescription description = wood("silver birch", 15.0f);
    const float all = leafShare(description.species[0].appearance, midautumn);
    ForestSimulation forest(description);
    EXPECT_LT(leavesAfter(forest, 0.0, 3.0), all);
    EXPECT_EQ(movingForest(*forest.cloneAtRest()).trees()[0].leaves, all);
    EXPECT_EQ(forest.currentDescription().trees[0].leaves, 1.0f);
    const TreeId second = TreeId(1);
    EXPECT_TRUE(forest.changeTree(second, *forest.placementOf(second)).empty());
    EXPECT_EQ(movingForest(forest).trees()[1].leaves, all);
    forest.reset();
    EXPECT_EQ(movingForest(forest).trees()[0].leaves, all);
    EXPECT_LT(leavesAfter(forest, 0.0, 3.0), all);
}
