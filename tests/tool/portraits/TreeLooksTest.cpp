// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/portraits/TreeLooks.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

using namespace osgTreeWind;

namespace {

const TreeLooks& looksOf(const std::string& species) {
    static std::map<std::string, TreeLooks> all;
    const auto [entry, isNew] = all.try_emplace(species);
    if (isNew)
        entry->second = measureLooks(*findSpecies(species));
    return entry->second;
}

} // namespace

TEST(TreeLooks, AsMuchSkyShowsThroughACrownAsInPhotographs) {
    struct Photographs { // Wilkinson 1992
        std::string species;
        double summer, winter;
    };
    const Photographs all[] = {
        {"oak", 0.17, 0.50},    {"beech", 0.19, 0.47},      {"silver birch", 0.24, 0.54},
        {"ash", 0.22, 0.53},    {"lime", 0.11, 0.54},       {"sycamore", 0.18, 0.54},
        {"poplar", 0.13, 0.50}, {"Scots pine", 0.27, 0.30}, {"horse chestnut", 0.19, 0.52}};
    double sum = 0.0;
    int count = 0;
    for (const Photographs& tree : all) {
        const TreeLooks& looks = looksOf(tree.species);
        const auto check = [&](double drawn, double seen, const char* season) {
            EXPECT_NEAR(drawn, seen, 0.09) << tree.species << " in " << season;
            sum += std::abs(drawn - seen);
            ++count;
        };
        check(looks.skyThroughCrownSummer, tree.summer, "summer");
        check(looks.skyThroughCrownWinter, tree.winter, "winter");
    }
    EXPECT_LT(sum / count, 0.045);
}

TEST(TreeLooks, CrownsAreAsWideForTheirStemsAsMeasured) {
    for (const char* species : {"oak", "sycamore", "silver birch", "Norway maple"}) { // Coombes et al. 2019
        EXPECT_GE(looksOf(species).crownOverStem, 22.0f) << species;
        EXPECT_LE(looksOf(species).crownOverStem, 28.0f) << species;
    }
}

TEST(TreeLooks, LeavesAreInclinedAsMeasured) {
    const std::pair<const char*, double> all[] = {{"beech", 18.0},   {"Norway maple", 27.0},
                                                  {"red oak", 27.0}, {"oak", 35.0},
                                                  {"aspen", 37.0},   {"silver birch", 56.0}};
    for (const auto& [species, degrees] : all) // Chianucci et al. 2018
        EXPECT_NEAR(looksOf(species).leafInclination, degrees, 5.0) << species;
}

TEST(TreeLooks, DrawnLeafAreaMatchesThatOfTheMechanics) {
    for (const Species& species : SpeciesCatalogue::current().species()) {
        const TreeLooks& looks = looksOf(species.name);
        EXPECT_NEAR(looks.leafAreaDrawn / looks.leafAreaMechanics, 1.0, 0.2) << species.name;
    }
}

TEST(TreeLooks, GreensVaryAndAreNotTooGreen) {
    for (const Species& species : SpeciesCatalogue::current().species()) {
        const TreeLooks& looks = looksOf(species.name);
        EXPECT_GE(looks.hueSpread, 15.0f) << species.name;
        EXPECT_GE(looks.greenShare, 0.36f) << species.name; // PhenoCam
        EXPECT_LE(looks.greenShare, 0.46f) << species.name;
    }
}

TEST(TreeLooks, ATreeWithoutLeavesHasNoLeafNumbers) {
    Species bare;
    bare.tree.leaves.clustersPerBranch = 0;
    const TreeLooks looks = measureLooks(bare);
    EXPECT_EQ(looks.leafAreaDrawn, 0.0f);
    EXPECT_EQ(looks.leafInclination, 0.0f);
    EXPECT_EQ(looks.hueSpread, 0.0f);
    EXPECT_EQ(looks.skyThroughCrownSummer, 0.0f);
    EXPECT_GT(looks.crownOverStem, 1.0f);
}
