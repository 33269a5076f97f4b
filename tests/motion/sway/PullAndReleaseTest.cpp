// SPDX-License-Identifier: MIT
#include <tests/TestData.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

using namespace osgTreeWind;

namespace {

TreePlacement sized(double height, double diameterInCentimetres) {
    TreePlacement tree;
    tree.size.height = static_cast<float>(height);
    tree.size.trunkDiameter = static_cast<float>(0.01 * diameterInCentimetres);
    return tree;
}

} // namespace

TEST(PullAndRelease, MatchesTwentyNineMeasuredTrees) {
    REQUIRE_REAL_DATA(path, "sway/NaturalFrequencies_FieldData.csv");
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::vector<double> ratios;
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; cells.size() < 6 && std::getline(row, cell, ',');)
            cells.push_back(cell);
        ASSERT_EQ(cells.size(), 6u);
        const Species species = findSpecies(cells[2]).value_or(defaultSpecies());
        const auto sway = pullAndRelease(species, sized(std::stod(cells[5]), std::stod(cells[4])));
        ASSERT_TRUE(sway) << line;
        EXPECT_GE(sway->dampingRatio, 0.05);
        EXPECT_LE(sway->dampingRatio, 0.15);
        ratios.push_back(sway->frequency / std::stod(cells[3]));
    }
    ASSERT_EQ(ratios.size(), 29u);
    std::sort(ratios.begin(), ratios.end());
    EXPECT_GE(ratios[14], 0.8);
    EXPECT_LE(ratios[14], 1.4); // the target is 1.25
    const auto near =
        std::count_if(ratios.begin(), ratios.end(), [](double r) { return r >= 0.5 && r <= 2.0; });
    EXPECT_GE(near, 21); // 70 % of 29
}

TEST(PullAndRelease, MatchesMeasuredSitkaSpruces) {
    // Milne 1991 (Tree Physiology 9:383): six trees, on average 14.2 m, 14.5 cm and 0.35 Hz.
    const auto sway = pullAndRelease(*findSpecies("Sitka spruce"), sized(14.2, 14.5));
    ASSERT_TRUE(sway);
    EXPECT_NEAR(sway->frequency, 0.35, 0.09);
}

TEST(PullAndRelease, ACriticallyDampedTreeDoesNotOscillate) {
    Species species = defaultSpecies();
    species.wood.dampingRatio = 1.5f;
    EXPECT_FALSE(pullAndRelease(species, sized(10, 20)));
}

TEST(PullAndRelease, FrequencyRisesWithDiameterAndFallsWithHeight) {
    const Species beech = *findSpecies("beech"); // its shapes vary less than those of oaks
    const double usual = pullAndRelease(beech, sized(15, 30))->frequency;
    EXPECT_GT(pullAndRelease(beech, sized(15, 45))->frequency, 1.15 * usual);
    EXPECT_LT(pullAndRelease(beech, sized(22, 30))->frequency, 0.8 * usual);
}

TEST(PullAndRelease, ABareTreeHasTheDampingRatioOfItsWood) {
    for (const Species& species : SpeciesCatalogue::current().species()) {
        TreePlacement tree = sized(20, 28);
        tree.leaves = 0.0f;
        const auto bare = pullAndRelease(species, tree);
        ASSERT_TRUE(bare) << species.name;
        EXPECT_GE(bare->dampingRatio, 0.98 * static_cast<double>(species.wood.dampingRatio));
        EXPECT_LT(bare->dampingRatio, 0.07) << species.name;
        const double leafy = pullAndRelease(species, sized(20, 28))->dampingRatio;
        EXPECT_GT(leafy, bare->dampingRatio + 0.001) << species.name;
        EXPECT_LT(leafy, 0.15) << species.name;
    }
}

TEST(PullAndRelease, LeavesIncreaseDampingByTheAir) {
    for (const Species& species : SpeciesCatalogue::current().species())
        for (const float height : {12.0f, 20.0f, 28.0f}) {
            const double damping = pullAndRelease(species, sized(height, 1.5f * height))->dampingRatio;
            EXPECT_GT(damping, species.appearance.hasNeedles() ? 0.056 : 0.06) << species.name;
            EXPECT_LT(damping, 0.15) << species.name;
        }
}

TEST(PullAndRelease, DampingByTheAirGrowsWithThePull) {
    const Species ash = *findSpecies("ash");
    const auto air = [&](double pull) {
        return pullAndRelease(ash, sized(20, 28), pull)->dampingRatio -
               static_cast<double>(ash.wood.dampingRatio);
    };
    EXPECT_GT(air(0.02) / air(0.01), 1.5);
    EXPECT_LT(air(0.02) / air(0.01), 2.1);
}
