// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/motion/damage/WindDamage.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace osgTreeWind;

namespace {

constexpr double step = 1.0 / 30.0;

/// Open-grown trees, 30 m apart, with different headings; their roots fail before their stems.
ForestDescription spruces(int count, float speed) {
    ForestDescription forest;
    forest.species = {*findSpecies("Norway spruce")};
    forest.species[0].wood.bendingStrength *= 20.0f;
    for (int i = 0; i < count; ++i) {
        TreePlacement tree;
        tree.position = {30.0 * (i % 10), 30.0 * (i / 10), 0.0};
        tree.heading = 0.9f * static_cast<float>(i);
        tree.size.height = 20.0f;
        tree.size.trunkDiameter = 0.20f + 0.01f * static_cast<float>(i % 5);
        forest.trees.push_back(tree);
    }
    forest.wind = std::make_shared<UniformWind>(glm::vec3(0.6f * speed, 0.8f * speed, 0.0f));
    forest.damage = true;
    return forest;
}

/// All damage between two times.
std::vector<TreeDamage> damageBetween(ForestSimulation& forest, double from, double to) {
    std::vector<TreeDamage> all;
    for (int i = 0; from + step * i <= to; ++i) {
        forest.advance(from + step * i);
        all.insert(all.end(), forest.damage().begin(), forest.damage().end());
    }
    return all;
}

/// The tip of a trunk: at rest, in the tree's own axes, and now, relative to its foot, in scene axes.
struct Top {
    glm::vec3 rest, now;
};
Top tipOf(const ForestSimulation& forest, std::size_t slot) {
    const PlacedTree& tree = movingForest(forest).trees()[slot];
    const std::vector<BranchUnit>& units = movingForest(forest).placed().modelOf(tree).skeleton.units;
    std::size_t top = 0;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0)
            top = i;
    const glm::vec3 rest = tree.scale.axes * units[top].tip;
    return {rest, rotateAboutZ(movingForest(forest).motion(slot).poses[top].apply(rest),
                               std::sin(tree.heading), std::cos(tree.heading))};
}
glm::vec3 topOf(const ForestSimulation& forest, std::size_t slot) {
    return tipOf(forest, slot).now;
}

} // namespace

TEST(WindDamage, DoesNotOccurInABreeze) {
    ForestSimulation forest(spruces(10, 8.0f));
    EXPECT_TRUE(damageBetween(forest, 0.0, 60.0).empty());
    for (std::size_t slot = 0; slot < 10; ++slot)
        EXPECT_TRUE(forest.isStanding(TreeId(slot)));
}

TEST(WindDamage, DoesNotOccurUnlessEnabled) {
    ForestDescription description = spruces(10, 60.0f);
    description.damage = false;
    ForestSimulation forest(description);
    EXPECT_TRUE(damageBetween(forest, 0.0, 40.0).empty());
    EXPECT_TRUE(forest.isStanding(TreeId(0)));
}

TEST(WindDamage, FellsTreesInAStorm) {
    ForestSimulation forest(spruces(20, 45.0f));
    EXPECT_TRUE(damageBetween(forest, 0.0, static_cast<double>(WindDamage::settlingTime) - 0.1).empty());
    const std::vector<TreeDamage> down = damageBetween(forest, 20.0, 60.0);
    std::set<TreeId> once;
    for (const TreeDamage& damage : down) {
        EXPECT_TRUE(once.insert(damage.tree).second);
        EXPECT_FALSE(forest.isStanding(damage.tree));
        EXPECT_EQ(damage.kind, DamageKind::Uprooted);
        EXPECT_GT(damage.moment, damage.limit);
        EXPECT_NEAR(glm::length(glm::vec2(damage.wind)), 45.0f, 1.0f);
        const std::size_t slot = slotOfTree(damage.tree);
        const glm::vec3 top = topOf(forest, slot);
        EXPECT_LT(top.z, 6.0f) << slot;
        EXPECT_NEAR(glm::length(top), glm::length(tipOf(forest, slot).rest), 0.01f) << "upright";
        EXPECT_GT(glm::dot(glm::normalize(glm::vec2(top)), glm::vec2(0.6f, 0.8f)), 0.98f) << "downwind";
        EXPECT_EQ(movingForest(forest).modal()->lean(slot), glm::vec2(0.0f));
    }
    EXPECT_EQ(down.size(), 20u);
    EXPECT_TRUE(forest.damage().empty());
}

/// In a slowly rising wind, each tree falls when its moment reaches the limit of its roots (ForestGALES).
TEST(WindDamage, EachTreeFailsAtItsLimit) {
    ForestDescription description = spruces(5, 0.0f);
    description.wind = std::make_shared<FunctionWind>(
        [](const glm::vec3&, double time) { return glm::vec3(0.3f * static_cast<float>(time), 0.0f, 0.0f); });
    ForestSimulation forest(description);
    const std::vector<TreeDamage> down = damageBetween(forest, 0.0, 200.0);
    ASSERT_EQ(down.size(), 5u);
    for (const TreeDamage& damage : down) {
        EXPECT_GE(damage.moment, damage.limit);
        EXPECT_LT(damage.moment, 1.01f * damage.limit);
    }
    for (std::size_t i = 1; i < down.size(); ++i)
        EXPECT_GE(down[i].wind.x, down[i - 1].wind.x);
    EXPECT_EQ(slotOfTree(down.back().tree), 4u) << "the thickest";
}

TEST(WindDamage, AStormDuringSettlingBreaksNothingLater) {
    ForestDescription description = spruces(3, 0.0f);
    description.species = {*findSpecies("Scots pine")};
    description.wind = std::make_shared<FunctionWind>(
        [](const glm::vec3&, double time) { return glm::vec3(time < 8.0 ? 60.0f : 2.0f, 0.0f, 0.0f); });
    ForestSimulation forest(description);
    EXPECT_TRUE(damageBetween(forest, 0.0, 40.0).empty());
}

TEST(WindDamage, AWeakStemSnapsAndLeavesAStump) {
    ForestDescription description = spruces(5, 40.0f);
    description.species[0].wood.bendingStrength = 4.0e6f;
    ForestSimulation forest(description);
    const std::vector<TreeDamage> down = damageBetween(forest, 0.0, 40.0);
    ASSERT_EQ(down.size(), 5u);
    for (const TreeDamage& damage : down) {
        EXPECT_EQ(damage.kind, DamageKind::Snapped);
        EXPECT_GT(damage.unit, 0u);
        const std::size_t slot = slotOfTree(damage.tree);
        const PlacedTree& tree = movingForest(forest).trees()[slot];
        const TreeMotion motion = movingForest(forest).motion(slot);
        const glm::vec3 stump =
            tree.scale.axes * movingForest(forest).placed().modelOf(tree).skeleton.units[damage.unit].base;
        EXPECT_GE(stump.z, 1.3f);
        EXPECT_LT(glm::distance(motion.poses[damage.unit].apply(stump), stump), 0.02f);
        EXPECT_LT(topOf(forest, slot).z, 4.0f);
        const UnitMotion one = movingForest(forest).unitMotion(slot, damage.unit);
        EXPECT_LT(glm::distance(one.pose.translation, motion.poses[damage.unit].translation), 1e-4f);
    }
}

/// Some boughs of an oak fail before its stem.
TEST(WindDamage, AtMostThreeBoughsPerTreeTearOff) {
    ForestDescription description = spruces(3, 0.0f);
    description.species = {*findSpecies("oak")};
    description.species[0].wood.anchorage = 0.0f;
    description.wind = std::make_shared<FunctionWind>(
        [](const glm::vec3&, double time) { return glm::vec3(0.5f * static_cast<float>(time), 0.0f, 0.0f); });
    std::vector<TreeDamage> down;
    ForestSimulation forest(description);
    for (const TreeDamage& damage : damageBetween(forest, 0.0, 60.0))
        if (damage.kind == DamageKind::BoughTorn)
            down.push_back(damage);
    ASSERT_FALSE(down.empty());
    std::map<TreeId, int> boughs;
    for (const TreeDamage& damage : down) {
        EXPECT_LE(++boughs[damage.tree], 3);
        EXPECT_GT(damage.moment, damage.limit);
        const std::size_t slot = slotOfTree(damage.tree);
        const PlacedTree& tree = movingForest(forest).trees()[slot];
        const BranchUnit& bough = movingForest(forest).placed().modelOf(tree).skeleton.units[damage.unit];
        EXPECT_EQ(bough.level, 1);
        const TreeMotion motion = movingForest(forest).motion(slot);
        const UnitPose& pose = motion.poses[damage.unit];
        if (forest.isStanding(damage.tree)) {
            EXPECT_LT(pose.apply(tree.scale.axes * bough.tip).z, pose.apply(tree.scale.axes * bough.base).z);
        }
        const UnitMotion one = movingForest(forest).unitMotion(slot, damage.unit);
        EXPECT_LT(glm::distance(one.pose.translation, pose.translation), 1e-3f);
    }
}

TEST(WindDamage, ReplacedTreesStand) {
    ForestSimulation forest(spruces(4, 45.0f));
    EXPECT_EQ(damageBetween(forest, 0.0, 40.0).size(), 4u);
    const TreeId first = TreeId(0), second = TreeId(1);
    EXPECT_TRUE(forest.changeTree(first, *forest.placementOf(first)).empty());
    EXPECT_TRUE(forest.isStanding(first));
    TreePlacement placement = *forest.placementOf(second);
    EXPECT_TRUE(forest.removeTree(second).empty());
    EXPECT_FALSE(forest.isStanding(second));
    placement.position.x += 5.0;
    const auto third = forest.addTree(placement);
    ASSERT_TRUE(third);
    EXPECT_TRUE(forest.isStanding(third.value()));
    EXPECT_TRUE(damageBetween(forest, 40.0, 41.0).empty());
    EXPECT_EQ(damageBetween(forest, 41.0, 80.0).size(), 2u) << "and falls again";
    forest.reset();
    for (const TreeId tree : forest.trees())
        EXPECT_TRUE(forest.isStanding(tree));
}

TEST(WindDamage, ACopyHasAllTreesStanding) {
    ForestSimulation forest(spruces(3, 45.0f));
    EXPECT_EQ(damageBetween(forest, 0.0, 40.0).size(), 3u);
    const auto copy = forest.cloneAtRest();
    EXPECT_TRUE(copy->isStanding(TreeId(0)));
    EXPECT_FALSE(forest.isStanding(TreeId(0)));
    EXPECT_TRUE(forest.currentDescription().damage);
}

TEST(WindDamage, APauseReportsNothingTwice) {
    ForestSimulation forest(spruces(3, 45.0f));
    double time = 0.0;
    while (forest.damage().empty() && time < 60.0)
        forest.advance(time += step);
    ASSERT_FALSE(forest.damage().empty());
    forest.advance(time);
    EXPECT_TRUE(forest.damage().empty());
}

TEST(WindDamage, ASeasonDoesNotRaiseFallenTrees) {
    ForestDescription description = spruces(2, 45.0f);
    description.species = {*findSpecies("silver birch")};
    ForestSimulation forest(description);
    EXPECT_EQ(damageBetween(forest, 0.0, 40.0).size(), 2u);
    EXPECT_TRUE(forest.setSeason(0.0f).empty());
    damageBetween(forest, 40.0, 41.0);
    EXPECT_FALSE(forest.isStanding(TreeId(0)));
    EXPECT_LT(topOf(forest, 0).z, 6.0f);
}

TEST(WindDamage, EveryTreeInAHurricaneStandsOrIsReportedOnce) {
    ForestDescription description = spruces(300, 0.0f);
    description.wind = std::make_shared<UniformWind>(glm::vec3(25.0f, 0.0f, 0.0f));
    description.wind.gusts.intensity = 0.2;
    ForestSimulation forest(description);
    std::map<TreeId, int> told;
    for (const TreeDamage& damage : damageBetween(forest, 0.0, 60.0))
        ++told[damage.tree];
    std::size_t down = 0;
    for (std::size_t slot = 0; slot < movingForest(forest).trees().size(); ++slot) {
        const TreeId tree = TreeId(slot);
        down += !forest.isStanding(tree);
        EXPECT_EQ(told.count(tree), forest.isStanding(tree) ? 0u : 1u);
        const glm::vec3 top = topOf(forest, slot);
        EXPECT_TRUE(std::isfinite(top.x + top.y + top.z));
    }
    EXPECT_GT(down, 10u);
    EXPECT_EQ(down, told.size());
}
