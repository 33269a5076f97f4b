// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/TreeSway.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/damage/FootLoad.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/sway/FreeSwayTree.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr double frame = 1.0 / 30.0;

/// A spruce of 20 m in a steady wind.
ForestDescription swayingSpruce(const glm::vec3& wind, float heading = 0.0f) {
    ForestDescription forest;
    forest.species = {*findSpecies("Norway spruce")};
    TreePlacement tree;
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.25f;
    tree.heading = heading;
    forest.trees = {tree};
    forest.wind = std::make_shared<UniformWind>(wind);
    return forest;
}

TreeSway swayAfter(ForestSimulation& forest, double seconds) {
    for (int i = 0; frame * i <= seconds; ++i)
        forest.advance(frame * i);
    return forest.sway(TreeId(0)).value();
}

} // namespace

TEST(TreeSwayTest, IsZeroAtRest) {
    const ForestSimulation forest(swayingSpruce(glm::vec3(0.0f)));
    const TreeSway sway = forest.sway(TreeId(0)).value();
    EXPECT_LT(glm::length(sway.displacement), 1e-5f);
    EXPECT_EQ(sway.velocity, glm::vec2(0.0f));
    EXPECT_LT(sway.lean, 1e-3f);
    EXPECT_LT(sway.moment(), 1.0);
    EXPECT_GT(sway.limit, 1e4);
    EXPECT_EQ(sway.windAtTop, glm::vec3(0.0f));
}

TEST(TreeSwayTest, MomentOfASteadyWindIsDragTimesHeight) {
    ForestSimulation forest(swayingSpruce(glm::vec3(10.0f, 0.0f, 0.0f)));
    const TreeSway sway = swayAfter(forest, 90.0);
    EXPECT_EQ(sway.windAtTop, glm::vec3(10.0f, 0.0f, 0.0f));
    EXPECT_GT(sway.displacement.x, 0.01f);
    EXPECT_LT(std::abs(sway.displacement.y), 0.3f * sway.displacement.x) << "it leans downwind";
    EXPECT_LT(glm::length(sway.velocity), 0.01f) << "it has come to rest";
    EXPECT_NEAR(sway.lean, std::atan(glm::length(sway.displacement) / 20.0f), 0.1f * sway.lean);

    // Drag areas are those at 10 m/s.
    const PlacedForest placed =
        makeSingleTreeForest(*findSpecies("Norway spruce"), swayingSpruce({}).trees.front());
    const PlacedTree& tree = placed.trees.front();
    const TreeModel& model = placed.modelOf(tree);
    const std::vector<UnitLoad> loads = makeUnitLoads(model, tree.scale, placed.speciesOf(tree), tree.leaves);
    double expected = 0.0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const BranchUnit& unit = model.skeleton.units[i];
        expected += 0.5 * static_cast<double>(airDensity) * 100.0 *
                    static_cast<double>((loads[i].woodDrag + loads[i].leafDrag) * 0.5f * tree.scale.axes.z *
                                        (unit.base.z + unit.tip.z));
    }
    EXPECT_NEAR(sway.windMoment.x, expected, 0.15 * expected);
    EXPECT_GT(sway.weightMoment.x, 0.0) << "the overhang adds to the wind";
    EXPECT_LT(sway.weightMoment.x, 0.5 * sway.windMoment.x);
}

TEST(TreeSwayTest, TheTopIsThatOfTheTreeAlsoWhereTheTrunkForks) {
    ForestDescription description = swayingSpruce(glm::vec3(10.0f, 0.0f, 0.0f));
    description.species = {*findSpecies("oak")};
    description.trees[0].size.trunkDiameter = 0.45f;
    ForestSimulation forest(description);
    const TreeSway sway = swayAfter(forest, 60.0);
    EXPECT_NEAR(sway.lean, std::atan(glm::length(sway.displacement) / 20.0f), 0.1f * sway.lean);
}

TEST(TreeSwayTest, DirectionsAreThoseOfTheForest) {
    for (const float heading : {0.0f, 1.0f, 2.5f, -2.0f}) {
        SCOPED_TRACE(heading);
        ForestSimulation forest(swayingSpruce(glm::vec3(0.0f, 12.0f, 0.0f), heading));
        const TreeSway sway = swayAfter(forest, 60.0);
        EXPECT_GT(sway.displacement.y, 3.0f * std::abs(sway.displacement.x));
        EXPECT_GT(sway.windMoment.y, 3.0 * std::abs(sway.windMoment.x));
        EXPECT_GT(sway.weightMoment.y, 3.0 * std::abs(sway.weightMoment.x));
    }
}

TEST(TreeSwayTest, VelocityIsThatOfTheDisplacement) {
    ForestSimulation forest(swayingSpruce(glm::vec3(12.0f, 0.0f, 0.0f)));
    swayAfter(forest, 20.0);
    EXPECT_TRUE(forest.setWind({}).empty());
    forest.advance(20.1);
    forest.advance(20.2);
    constexpr double small = 0.01;
    for (double time = 20.3; time < 24.0; time += 0.4) {
        forest.advance(time - small);
        const glm::vec2 before = forest.sway(TreeId(0))->displacement;
        forest.advance(time);
        const glm::vec2 velocity = forest.sway(TreeId(0))->velocity;
        forest.advance(time + small);
        const glm::vec2 after = forest.sway(TreeId(0))->displacement;
        const glm::vec2 measured = (after - before) / static_cast<float>(2.0 * small);
        EXPECT_LT(glm::distance(velocity, measured), 0.05f * glm::length(measured) + 0.02f) << time;
    }
}

TEST(TreeSwayTest, FrequencyIsThatOfAFreeSway) {
    for (const char* species : {"Norway spruce", "oak", "birch"}) {
        ForestDescription description = swayingSpruce(glm::vec3(0.0f));
        description.species = {*findSpecies(species)};
        const ForestSimulation forest(description);
        FreeSwayTree alone(description.species[0], description.trees[0]);
        const double expected = alone.omega(0) / glm::two_pi<double>();
        EXPECT_NEAR(forest.sway(TreeId(0))->frequency, expected, 0.05 * expected) << species;
    }
}

TEST(TreeSwayTest, ATreeFallsWhereItsMomentExceedsTheLimit) {
    ForestDescription description = swayingSpruce(glm::vec3(45.0f, 0.0f, 0.0f));
    description.damage = true;
    ForestSimulation forest(description);
    double largest = 0.0;
    for (int i = 0; i < 3000 && forest.isStanding(TreeId(0)); ++i) {
        if (const auto sway = forest.sway(TreeId(0)))
            largest = std::max(largest, sway->moment());
        forest.advance(frame * i);
    }
    ASSERT_FALSE(forest.isStanding(TreeId(0)));
    ASSERT_EQ(forest.damage().size(), 1u);
    EXPECT_FALSE(forest.sway(TreeId(0))) << "a fallen tree does not sway";
    EXPECT_GT(forest.damage().front().moment, forest.damage().front().limit);
    const TreeSway whole = ForestSimulation(description).sway(TreeId(0)).value();
    EXPECT_NEAR(whole.limit, static_cast<double>(forest.damage().front().limit), 1e-4 * whole.limit);
    EXPECT_GT(largest, 0.0);
}

TEST(TreeSwayTest, IsEmptyForUnknownTreesAndBranchwiseLaws) {
    EXPECT_FALSE(ForestSimulation(swayingSpruce(glm::vec3(0.0f))).sway(TreeId(1)));
    EXPECT_FALSE(ForestSimulation(swayingSpruce(glm::vec3(0.0f))).sway(TreeId(99)));
    ForestDescription thesis = swayingSpruce(glm::vec3(5.0f, 0.0f, 0.0f));
    thesis.law = MotionLaw::Thesis;
    EXPECT_FALSE(ForestSimulation(thesis).sway(TreeId(0)));
}

TEST(TreeSwayTest, TheGainShowsMoreSwayAndNoMoreLoad) {
    ForestDescription plain = swayingSpruce(glm::vec3(8.0f, 0.0f, 0.0f)), shown = plain;
    shown.gain = 3.0f;
    ForestSimulation a(plain), b(shown);
    const TreeSway one = swayAfter(a, 60.0), three = swayAfter(b, 60.0);
    EXPECT_NEAR(three.displacement.x, 3.0f * one.displacement.x, 0.1f * three.displacement.x);
    EXPECT_NEAR(three.moment(), one.moment(), 0.1 * one.moment());
}
