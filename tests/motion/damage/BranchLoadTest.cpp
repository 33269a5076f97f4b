// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/BranchLoad.h>

#include <tests/motion/GrownTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace osgTreeWind;

namespace {

ForestDescription treeInWind(const char* species, WindFieldPtr wind, float heading = 0.0f) {
    ForestDescription forest;
    forest.species = {*findSpecies(species)};
    TreePlacement tree;
    tree.size.height = 16.0f;
    tree.heading = heading;
    forest.trees = {tree};
    forest.wind = std::move(wind);
    return forest;
}

void advance(ForestSimulation& forest, double seconds) {
    for (int i = 0; i <= static_cast<int>(30.0 * seconds); ++i)
        forest.advance(i / 30.0);
}

} // namespace

TEST(BranchLoadTest, AtTheFootIsTheMomentOfTheTree) {
    for (const char* species : {"Norway spruce", "oak"}) {
        SCOPED_TRACE(species);
        ForestSimulation forest(treeInWind(species, gustsOf(10.0f), 2.0f));
        advance(forest, 20.0);
        const TreeSway sway = forest.sway(TreeId(0)).value();
        const BranchLoad foot = forest.branchLoads(TreeId(0)).at(0);
        const glm::dvec2 moment = sway.windMoment + sway.weightMoment;
        EXPECT_GT(glm::length(moment), 1000.0);
        EXPECT_LT(glm::distance(glm::dvec2(foot.moment), moment), 1e-5 * glm::length(moment));
        EXPECT_EQ(foot.limit, sway.limit);
    }
}

/// A bough tears where the load reported for it exceeds its limit.
TEST(BranchLoadTest, IsThatWhichTearsBoughs) {
    ForestDescription description = treeInWind("oak", gustsOf(38.0f));
    description.species[0].wood.anchorage *= 20.0f; // the tree stands
    description.damage = true;
    ForestSimulation forest(description);
    std::size_t torn = 0;
    for (int i = 0; i < 30 * 120 && torn == 0; ++i) {
        forest.advance(i / 30.0);
        for (const TreeDamage& damage : forest.damage()) {
            if (damage.kind != DamageKind::BoughTorn)
                continue;
            ++torn;
            const BranchLoad load = forest.branchLoads(TreeId(0)).at(damage.unit);
            EXPECT_NEAR(glm::length(load.moment), static_cast<double>(damage.moment), 1e-5 * load.limit);
            EXPECT_NEAR(load.limit, static_cast<double>(damage.limit), 1e-5 * load.limit);
            EXPECT_GT(glm::length(load.moment), load.limit);
        }
    }
    EXPECT_GT(torn, 0u);
}

TEST(BranchLoadTest, VectorsPointToWhereTheWindBlows) {
    for (const float heading : {0.0f, 1.0f, -2.0f}) {
        ForestSimulation forest(
            treeInWind("Norway spruce", std::make_shared<UniformWind>(glm::vec3(0, 12, 0)), heading));
        advance(forest, 60.0);
        const BranchLoad foot = forest.branchLoads(TreeId(0)).at(0);
        EXPECT_GT(foot.moment.y, 3.0 * std::abs(foot.moment.x)) << heading;
        EXPECT_GT(foot.tilt.y, 3.0f * std::abs(foot.tilt.x)) << heading;
        EXPECT_LT(foot.tilt.z, 0.0f);
    }
}

/// A bough tears where the stress in its wood, strain times modulus, is the strength of the wood.
TEST(BranchLoadTest, StrainAtTheLimitOfABoughIsThatOfBreakingWood) {
    const ForestSimulation forest(treeInWind("oak", nullptr));
    const PlacedForest& placed = movingForest(forest).placed();
    const TreeForm tree = makeModalTree(placed, placed.trees[0]).form;
    const std::vector<UnitLoad> units = makeUnitLoads(*tree.model, tree.scale, *tree.species, tree.leaves);
    const std::vector<BranchLoad> loads = forest.branchLoads(TreeId(0));
    const double strength = tree.species->wood.knotFactor * tree.species->wood.bendingStrength;
    std::size_t boughs = 0;
    for (std::size_t i = 1; i < loads.size(); ++i) {
        if (!(loads[i].limit > 0.0))
            continue;
        ++boughs;
        EXPECT_NEAR(loads[i].strain * loads[i].limit * static_cast<double>(units[i].modulus), strength,
                    1e-5 * strength);
    }
    EXPECT_GT(boughs, 10u);
}

TEST(BranchLoadTest, IsEmptyForUnknownTreesAndBranchwiseLaws) {
    EXPECT_TRUE(ForestSimulation(treeInWind("oak", nullptr)).branchLoads(TreeId(1)).empty());
    ForestDescription thesis = treeInWind("oak", nullptr);
    thesis.law = MotionLaw::Thesis;
    EXPECT_TRUE(ForestSimulation(thesis).branchLoads(TreeId(0)).empty());
}
