// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SeasonDay.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <limits>

namespace osgTreeWind {
namespace {

Appearance looksOf(const char* species) {
    return findSpecies(species)->appearance;
}

ForestDescription wood(float season, MotionLaw law = MotionLaw::Modal) {
    ForestDescription forest;
    forest.species = {*findSpecies("oak"), *findSpecies("Norway spruce")};
    for (Species& species : forest.species)
        species.shapes = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        TreePlacement tree;
        tree.species = i % 2;
        tree.position = {10.0 * static_cast<double>(i), 0.0, 0.0};
        tree.size.height = 15.0f;
        tree.leaves = i < 2 ? 1.0f : 0.8f;
        forest.trees.push_back(tree);
    }
    forest.law = law;
    forest.season = season;
    forest.wind = std::make_shared<UniformWind>(glm::vec3(8, 1, 0));
    return forest;
}

/// Largest difference between the poses and angles of two forests, metres and radians.
float largestDifference(const ForestSimulation& a, const ForestSimulation& b) {
    float most = 0.0f;
    for (std::size_t tree = 0; tree < movingForest(a).trees().size(); ++tree) {
        const TreeMotion ma = movingForest(a).motion(tree), mb = movingForest(b).motion(tree);
        for (std::size_t unit = 0; unit < ma.poses.size; ++unit)
            most = std::max(most, glm::length(ma.poses[unit].translation - mb.poses[unit].translation) +
                                      glm::length(ma.states[unit] - mb.states[unit]));
    }
    return most;
}

TEST(Season, EveryDayHasItsSeason) {
    for (int day = 0; day < 365; ++day)
        EXPECT_EQ(dayOfSeason(seasonOfDay(day)), day);
    EXPECT_EQ(dayOfSeason(midwinter), 34);
    EXPECT_EQ(dayOfSeason(midautumn), 308);
}

TEST(Season, ParsesWordsNumbersAndDates) {
    EXPECT_EQ(parseSeason("winter"), midwinter);
    EXPECT_EQ(parseSeason("spring"), midspring);
    EXPECT_EQ(parseSeason("summer"), midsummer);
    EXPECT_EQ(parseSeason("autumn"), midautumn);
    EXPECT_EQ(parseSeason("2.25"), 2.25f);
    EXPECT_NEAR(*parseSeason("2023-02-04"), midwinter, 1e-4);
    EXPECT_NEAR(*parseSeason("2024-05-05"), midspring, 0.02);
    EXPECT_NEAR(*parseSeason("2024-08-06"), midsummer, 0.02);
    EXPECT_NEAR(*parseSeason("2024-11-05"), midautumn, 0.02);
    EXPECT_NEAR(*parseSeason("2025-02-03"), 4.0, 0.02);
    EXPECT_TRUE(parseSeason("2024-02-29"));
}

TEST(Season, RefusesOtherTexts) {
    for (const char* text : {"", "Summer", "fall", "-1", "4.1", "nan", "2024-13-01", "2024-00-10",
                             "2023-02-29", "2024-04-31", "2024-4-1", "2024-05-05x", "05-05"})
        EXPECT_FALSE(parseSeason(text)) << text;
}

TEST(Season, BroadleavesAreBareInWinterAndFullInSummer) {
    const Appearance oak = looksOf("oak");
    EXPECT_EQ(leafShare(oak, midwinter), 0.0f);
    EXPECT_EQ(leafShare(oak, *parseSeason("2024-01-15")), 0.0f);
    EXPECT_EQ(leafShare(oak, *parseSeason("2024-06-21")), 1.0f);
    EXPECT_EQ(leafShare(oak, midsummer), 1.0f);
    EXPECT_NEAR(leafShare(oak, midautumn), 0.5,
                0.15); // PEP725: half of the leaves have fallen about 1 November
    EXPECT_GT(leafShare(oak, midspring), 0.4f);
    EXPECT_LT(leafShare(oak, midspring), 0.9f);
    EXPECT_EQ(leafColor(oak, midsummer), oak.leaves);
    EXPECT_EQ(leafColor(oak, midspring), oak.springLeaves);
    EXPECT_EQ(leafColor(oak, midautumn), oak.autumnLeaves);
}

TEST(Season, EvergreensKeepTheirLeaves) {
    const Appearance spruce = looksOf("Norway spruce");
    for (float season = 0.0f; season < 4.0f; season += 0.25f) {
        EXPECT_EQ(leafShare(spruce, season), 1.0f);
        if (season <= 0.75f || season >= midsummer) {
            EXPECT_EQ(leafColor(spruce, season), spruce.leaves);
        }
    }
    for (const float season : {midspring, 1.25f, 1.5f}) {
        const glm::vec3 shoots = shootColor(spruce, season), all = leafColor(spruce, season);
        EXPECT_GT(shoots.g, 1.2f * all.g) << "shoots of this year are paler";
        EXPECT_GT(shoots.r / shoots.b, 1.2f * all.r / all.b) << "and yellower";
        EXPECT_EQ(shootColor(looksOf("oak"), season), leafColor(looksOf("oak"), season));
        EXPECT_EQ(shootColor(looksOf("palm"), season), looksOf("palm").leaves);
    }
    Appearance holly;
    holly.evergreen = true;
    EXPECT_EQ(leafShare(holly, midwinter), 1.0f);
    Appearance larch;
    larch.leafForm = LeafForm::Tufts;
    EXPECT_EQ(leafShare(larch, midwinter), 0.0f);
}

TEST(Season, IsPeriodicAndContinuous) {
    const Appearance oak = looksOf("oak");
    for (float season = -8.0f; season < 8.0f; season += 0.01f) {
        EXPECT_NEAR(leafShare(oak, season), leafShare(oak, season + 0.01f), 0.06);
        EXPECT_LT(glm::length(leafColor(oak, season) - leafColor(oak, season + 0.01f)), 0.3f);
        EXPECT_NEAR(leafShare(oak, season), leafShare(oak, season + 4.0f), 1e-3);
    }
    EXPECT_EQ(leafShare(oak, std::numeric_limits<float>::quiet_NaN()), 1.0f);
}

TEST(Season, BroadleavesSwayFasterAndLongerInWinter) {
    TreePlacement summer;
    summer.size.height = 20.0f;
    summer.size.trunkDiameter = 0.3f;
    for (const char* name : {"oak", "beech", "silver birch"}) {
        const Species species = *findSpecies(name);
        TreePlacement winter = summer;
        winter.leaves = leafShare(species.appearance, midwinter);
        const FreeSway on = *pullAndRelease(species, summer), off = *pullAndRelease(species, winter);
        // Bunce et al. 2019 found red oaks 1.0 to 1.5 times as fast once their leaves had fallen.
        EXPECT_GT(off.frequency, 1.01 * on.frequency) << name;
        EXPECT_LT(off.frequency, 1.6 * on.frequency) << name;
        EXPECT_LT(off.dampingRatio, on.dampingRatio) << name;
    }
    EXPECT_EQ(leafShare(looksOf("spruce"), midwinter), leafShare(looksOf("spruce"), midsummer));
}

TEST(Season, ChangedForestEqualsOneMadeInTheSeason) {
    for (const MotionLaw law : {MotionLaw::Modal, MotionLaw::Thesis}) {
        ForestSimulation changed(wood(midsummer, law)), made(wood(midwinter, law)),
            summer(wood(midsummer, law));
        EXPECT_TRUE(changed.setSeason(midwinter).empty());
        EXPECT_EQ(changed.season(), midwinter);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(movingForest(changed).trees()[i].leaves, movingForest(made).trees()[i].leaves);
        for (ForestSimulation* forest : {&changed, &made, &summer})
            for (int frame = 0; frame <= 90; ++frame)
                forest->advance(frame / 30.0);
        EXPECT_LT(largestDifference(changed, made), 1e-6f);
        if (law != MotionLaw::Thesis) { // it ignores the leaves
            EXPECT_GT(largestDifference(changed, summer), 1e-3f);
        }
        EXPECT_TRUE(changed.setSeason(midsummer).empty());
        EXPECT_EQ(movingForest(changed).trees()[2].leaves, 0.8f);
    }
}

TEST(Season, LargeForestUpdatesInStepsToTheSameResult) {
    const auto large = [](float season) {
        ForestDescription forest = wood(season);
        const std::vector<TreePlacement> few = std::exchange(forest.trees, {});
        for (std::size_t i = 0; i < 1000; ++i) {
            forest.trees.push_back(few[i % few.size()]);
            forest.trees.back().size.height = 3.0f + 0.03f * static_cast<float>(i);
        }
        return forest;
    };
    ForestSimulation changed(large(midsummer)), made(large(midwinter));
    EXPECT_TRUE(changed.setSeason(midwinter).empty());
    EXPECT_EQ(movingForest(changed).trees()[996].leaves, 0.0f) << "at once";
    const std::size_t archetypes = movingForest(changed).modal()->archetypeCount();
    EXPECT_TRUE(changed.removeTree(TreeId(999)).empty());
    EXPECT_TRUE(made.removeTree(TreeId(999)).empty());
    const std::shared_ptr<ForestSimulation> copy = changed.cloneAtRest();
    for (ForestSimulation* forest : {&changed, copy.get(), &made}) {
        for (int frame = 0; frame <= 20; ++frame)
            forest->advance(frame / 30.0);
        forest->reset();
        for (int frame = 0; frame <= 20; ++frame)
            forest->advance(frame / 30.0);
    }
    EXPECT_GT(movingForest(changed).modal()->archetypeCount(), archetypes) << "made in steps";
    for (std::size_t slot = 0; slot < 999; ++slot) {
        ASSERT_EQ(movingForest(changed).modal()->lean(slot), movingForest(made).modal()->lean(slot)) << slot;
        ASSERT_EQ(movingForest(*copy).modal()->lean(slot), movingForest(made).modal()->lean(slot)) << slot;
    }
}

TEST(Season, AppliesToAddedTreesAndCopies) {
    ForestSimulation forest(wood(midwinter));
    TreePlacement tree;
    tree.leaves = 0.5f;
    const TreeId oak = forest.addTree(tree).value();
    EXPECT_EQ(movingForest(forest).trees()[slotOfTree(oak)].leaves, 0.0f);
    EXPECT_EQ(forest.placementOf(oak)->leaves, 0.5f);
    EXPECT_TRUE(forest.setSeason(midsummer).empty());
    const auto copy = forest.cloneAtRest();
    EXPECT_EQ(copy->season(), midsummer);
    EXPECT_EQ(movingForest(*copy).trees()[slotOfTree(oak)].leaves, 0.5f);
    EXPECT_TRUE(copy->setSeason(midwinter).empty());
    EXPECT_EQ(forest.season(), midsummer);
}

TEST(Season, ChangesWithoutAJumpOfSwayingTrees) {
    ForestSimulation forest(wood(midsummer));
    for (int frame = 0; frame <= 60; ++frame)
        forest.advance(frame / 30.0);
    const glm::vec2 before = movingForest(forest).modal()->lean(0);
    EXPECT_TRUE(forest.setSeason(midautumn).empty());
    EXPECT_LT(glm::distance(movingForest(forest).modal()->lean(0), before), 0.1f * glm::length(before));
    EXPECT_GT(glm::length(before), 0.01f);
}

} // namespace
} // namespace osgTreeWind
