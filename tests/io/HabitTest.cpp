// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <tests/base/FirstProblem.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace osgTreeWind {
namespace {

Result<ForestFile> readHabitFile(const std::string& text) {
    std::istringstream input("version = 1\n" + text + "[[tree]]\nposition = [0, 0]\n");
    return readForest(input, {"a.treewind", "/nowhere"});
}

std::string habitRefusal(const std::string& text) {
    const auto forest = readHabitFile(text);
    return forest ? "" : forest.problems().front().text();
}

Species speciesByLight(const std::string& text) {
    const auto forest = readHabitFile(text);
    EXPECT_TRUE(forest) << firstProblem(forest);
    return forest.value().species.front();
}

const std::string oakByLight =
    "[[species]]\nname = \"an oak\"\nlike = \"oak\"\n[species.habit]\nlike = \"oak\"\n";

} // namespace

TEST(Habit, BuiltInSpeciesHaveValidHabits) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        if (species.name == "palm")
            continue;
        ASSERT_TRUE(species.tree.growth) << species.name;
        Diagnostics problems;
        checkKeys(*species.tree.growth, "", problems);
        EXPECT_TRUE(problems.empty()) << species.name << ": " << problems.front().text();
        EXPECT_FALSE(species.tree.growth->habit.model.empty()) << species.name;
    }
}

TEST(Habit, LikeCopiesTheSizeUnlessGiven) {
    const GrowthGoal model = SpeciesCatalogue::builtIn().find("oak")->tree.growth->size;
    const GrowthGoal grown = speciesByLight(oakByLight).tree.growth->size;
    EXPECT_FLOAT_EQ(grown.height, model.height);
    EXPECT_FLOAT_EQ(grown.crownWidth, model.crownWidth);
    EXPECT_FLOAT_EQ(grown.trunkDiameter, model.trunkDiameter);
    const Species told = speciesByLight(oakByLight + "height = 9\nbranch_angle = [80, 70, 60, 50]\n");
    EXPECT_FLOAT_EQ(told.tree.growth->size.height, 9.0f);
    EXPECT_FLOAT_EQ(told.tree.growth->habit.branchAngle[3], 0.87266463f);
}

TEST(Habit, TreeHasItsSizeAndLeavesOnItsShoots) {
    const Species species =
        speciesByLight(oakByLight + "height = 12\ntrunk_diameter = 0.4\ncrown_width = 9\n");
    const TreeModel model = makeTreeModel(species.tree);
    const TreeSize size = measureTree(model);
    EXPECT_NEAR(size.height, 12.0f, 0.8f); // including leaves
    EXPECT_NEAR(size.trunkDiameter, 0.4f, 0.03f);
    EXPECT_NEAR(size.crownWidth, 9.0f, 2.0f);
    EXPECT_LE(model.skeleton.units.size(), 250u);
    EXPECT_GT(model.skeleton.shoots.size(), 500u);
    EXPECT_EQ(model.skeleton.leafyUnits.size(), model.skeleton.units.size());
    EXPECT_NEAR(static_cast<double>(model.leaves.size()), 3000.0, 30.0);
    for (const LeafCluster& leaf : model.leaves)
        EXPECT_GT(leaf.anchor.z, 0.3f);
}

TEST(Habit, TreesInAStandGrowInShade) {
    const Species species = speciesByLight(oakByLight);
    ASSERT_TRUE(growsByLight(species));
    EXPECT_EQ(growthOf(species, true).growth->site.shade, 0.0f);
    EXPECT_GT(growthOf(species, false).growth->site.shade, 0.2f);
    const TreeModel open = makeTreeModel(growthOf(species, true)),
                    closed = makeTreeModel(growthOf(species, false));
    const auto lowest = [](const TreeModel& model) { // 5 % quantile
        std::vector<float> heights;
        for (const LeafCluster& leaf : model.leaves)
            heights.push_back(leaf.anchor.z);
        std::sort(heights.begin(), heights.end());
        return heights[heights.size() / 20];
    };
    EXPECT_GT(lowest(closed), lowest(open) + 1.0f);
}

TEST(Habit, ReadsBackExactly) {
    const auto forest =
        readHabitFile(oakByLight + "model = \"Massart\"\nsink = [0, -1.5, 3, 120]\nseed = 7\n");
    ASSERT_TRUE(forest) << firstProblem(forest);
    std::stringstream text;
    ASSERT_TRUE(writeForest(forest.value(), text).empty());
    const auto again = readForest(text, {"b.treewind", "/nowhere"});
    ASSERT_TRUE(again) << firstProblem(again);
    EXPECT_TRUE(areKeysEqual(*again.value().species.front().tree.growth,
                             *forest.value().species.front().tree.growth));
}

TEST(Habit, ReportsInvalidValues) {
    const std::string start = "[[species]]\nname = \"a\"\n";
    EXPECT_EQ(habitRefusal(start + "[species.habit]\nlike = \"kelp\"\n"),
              "a.treewind:5:8: species.habit.like: no built-in species with a habit is called \"kelp\"");
    EXPECT_EQ(habitRefusal(start + "[species.growth]\n[species.habit]\n"),
              "a.treewind:5:1: species.habit: give either this or growth");
    EXPECT_EQ(habitRefusal(start + "[species.habit]\nrise = [0, 1, 7, 0]\n").find("a.treewind:5"), 0u);
    EXPECT_EQ(habitRefusal(start + "[species.habit]\nrise = [0, 1]\n").find("a.treewind:5"), 0u);
    EXPECT_EQ(habitRefusal(start + "[species.habit]\nrise = 3\n").find("a.treewind:5"), 0u);
    EXPECT_EQ(habitRefusal(start + "[species.habit]\ndeepest = nan\n").find("a.treewind:5"), 0u);
}

} // namespace osgTreeWind
