// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/SwayModes.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

TreePlacement tall(float leaves = 1.0f) {
    TreePlacement tree;
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.3f;
    tree.leaves = leaves;
    return tree;
}

} // namespace

TEST(SwayModes, TheFirstModesHaveTheFrequencyOfAPulledTree) {
    const Species spruce = *findSpecies("Norway spruce");
    const std::vector<SwayMode> modes = swayModes(spruce, tall());
    ASSERT_GE(modes.size(), 8u);
    const FreeSway free = *pullAndRelease(spruce, tall());
    EXPECT_NEAR(modes[0].frequency / free.frequency, 1.0, 0.05);
    EXPECT_NEAR(modes[1].frequency / free.frequency, 1.0, 0.05);
}

TEST(SwayModes, SharesOfTheEnergySumToOneOrLess) {
    double sum = 0.0;
    for (const SwayMode& mode : swayModes(*findSpecies("oak"), tall())) {
        EXPECT_GE(mode.share, 0.0);
        sum += mode.share;
    }
    EXPECT_GT(sum, 0.8);
    EXPECT_LE(sum, 1.0 + 1e-6);
}

TEST(SwayModes, AirAddsToTheDampingOfWood) {
    const Species ash = *findSpecies("ash");
    const double wood = ash.wood.dampingRatio;
    for (const SwayMode& mode : swayModes(ash, tall())) {
        EXPECT_GE(mode.dampingRatio, 0.99 * wood);
        EXPECT_LT(mode.dampingRatio, 0.3);
    }
    EXPECT_GT(swayModes(ash, tall())[0].dampingRatio, 1.02 * wood);
}

TEST(SwayModes, AModeThatDoesNotSwingIsCritical) {
    Species species = defaultSpecies();
    species.wood.dampingRatio = 1.5f;
    for (const SwayMode& mode : swayModes(species, tall()))
        EXPECT_EQ(mode.dampingRatio, 1.0);
}
