// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

TreeStrength strengthOf(const Species& species, float diameter, float height) {
    TreeSize size;
    size.trunkDiameter = diameter;
    size.height = height;
    const GrownTree tree(species, size);
    return {tree.model, tree.scale, tree.species};
}

} // namespace

// Sitka spruce in ForestGALES (R package fgr): 34 MPa without knots; 162.5 N m/kg, the mean over rooting
// depths on freely draining mineral soil; 850 kg/m3; stem volume 6.8e-5 d^1.827 h^0.981 m3 (cm, m); crown
// depth 2.4682 + 0.3667 h m, with the wind load at its middle z; a foot thicker than breast height by (z / (z
// - 1.3))^0.333. Our crown begins lower, so a smaller part of the moment at the foot acts at breast height.
TEST(TreeStrength, MatchesForestGales) {
    const TreeStrength spruce = strengthOf(*findSpecies("Sitka spruce"), 0.24f, 20.0f);
    const double pushed = 20.0 - 0.5 * (2.4682 + 0.3667 * 20.0);
    const double foot = 0.24 * std::pow(pushed / (pushed - 1.3), 0.333);
    EXPECT_NEAR(spruce.breaking / (34e6 * 3.14159265 * foot * foot * foot / 32.0), 1.0, 0.05);
    const double stem = 850.0 * 6.8e-5 * std::pow(24.0, 1.827421) * std::pow(20.0, 0.981362);
    EXPECT_NEAR(spruce.uproot / (162.5 * stem), 1.0, 0.15);
}

TEST(TreeStrength, KnotsReduceStrength) {
    Species pine = *findSpecies("Scots pine");
    const double knotty = strengthOf(pine, 0.3f, 20.0f).breaking;
    pine.wood.knotFactor = 1.0f;
    EXPECT_NEAR(knotty / strengthOf(pine, 0.3f, 20.0f).breaking, 0.85, 1e-6);
}

// A load at height z has the arm z at the foot and z - 1.3 m at breast height.
TEST(TreeStrength, LowerCrownsMakeStemsStronger) {
    Species pole = *findSpecies("Norway spruce");
    const double breast = breakingMoment(pole.wood, 0.24);
    const auto withCrownFrom = [&](float base) { // over the height
        pole.crown.depthPerHeight = 1.0f - base;
        return strengthOf(pole, 0.24f, 20.0f).breaking / breast;
    };
    EXPECT_NEAR(withCrownFrom(0.5f), 15.0 / 13.7, 0.01);
    EXPECT_NEAR(withCrownFrom(0.75f), 17.5 / 16.2, 0.015);
}

TEST(TreeStrength, UnknownStrengthIsZero) {
    Species palm = *findSpecies("palm");
    EXPECT_EQ(strengthOf(palm, 0.3f, 10.0f).breaking, 0.0);
    palm.wood.anchorage = 0.0f;
    EXPECT_EQ(strengthOf(palm, 0.3f, 10.0f).uproot, 0.0);
}

} // namespace osgTreeWind
