// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/GrowthLaws.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>

#include <tests/TestData.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

using namespace osgTreeWind;

TEST(GrowthLaws, CrownWidthFollowsTrunkAndSite) {
    const Species oak = *findSpecies("oak");
    TreeSize size;
    size.trunkDiameter = 0.4f;
    const float forest = withCrown(size, oak.crown, false).crownWidth;
    const float open = withCrown(size, oak.crown, true).crownWidth;
    EXPECT_NEAR(forest, 0.36f + 0.19f * 40.0f, 0.05f);              // ForestGALES
    EXPECT_NEAR(open / 0.3048f, 3.12f + 1.829f * 40 / 2.54f, 0.2f); // Krajicek et al. 1961, feet and inches
    EXPECT_GT(open / size.trunkDiameter, 23.0f); // Coombes et al. 2019: 24 to 27 free-standing in towns
    EXPECT_LT(open / size.trunkDiameter, 28.0f);
}

TEST(GrowthLaws, GivenOrUnknownCrownsStay) {
    const Species oak = *findSpecies("oak");
    TreeSize size;
    EXPECT_EQ(withCrown(size, oak.crown, true).crownWidth, 0.0f);
    size.trunkDiameter = 0.4f;
    EXPECT_EQ(withCrown(size, {}, true).crownWidth, 0.0f);
    size.crownWidth = 3.0f;
    EXPECT_EQ(withCrown(size, oak.crown, true).crownWidth, 3.0f);
}

TEST(GrowthLaws, OpenCrownWidthsMatchThoseOfACampus) {
    REQUIRE_REAL_DATA(path, "utah_campus/utah_campus_trees.csv");
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const CrownAllometry crown = defaultSpecies().crown;
    std::vector<double> ratios; // trunks of 20 to 90 cm: few are young street trees
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(cell);
        TreeSize size;
        size.trunkDiameter = std::strtof(cells.at(2).c_str(), nullptr);
        const float width = std::strtof(cells.at(3).c_str(), nullptr);
        const std::string genus = cells.at(7).substr(0, cells.at(7).find(' '));
        const bool conifer = genus == "Pinus" || genus == "Picea" || genus == "Abies" || genus == "Juniperus";
        if (!conifer && width > 0.0f && size.trunkDiameter > 0.2f && size.trunkDiameter < 0.9f)
            ratios.push_back(withCrown(size, crown, true).crownWidth / width);
    }
    ASSERT_GT(ratios.size(), 400u);
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2),
                     ratios.end());
    const double median = ratios[ratios.size() / 2];
    EXPECT_GT(median, 0.7) << median;
    EXPECT_LT(median, 1.1) << median;
}

namespace {

/// Species with the crown depth of Sitka spruce in ForestGALES.
Species withForestCrown(const std::string& name) {
    Species kind = *findSpecies(name);
    kind.crown.depth = 2.4682f;
    kind.crown.depthPerHeight = 0.3667f;
    return kind;
}

} // namespace

TEST(GrowthLaws, CrownBaseInAForestMatchesForestGales) {
    const Species sitka = withForestCrown("Sitka spruce");
    const float height = sitka.tree.growth->size.height;
    const TreeModel model = makeTreeModel(growthOf(sitka, false));
    const std::vector<BranchUnit>& units = model.skeleton.units;
    std::vector<float> feet; // of the boughs that bear leaves
    for (const LeafCluster& leaf : model.leaves) {
        int unit = leaf.unit;
        while (units[static_cast<std::size_t>(unit)].level > 1)
            unit = units[static_cast<std::size_t>(unit)].parent;
        if (units[static_cast<std::size_t>(unit)].level == 1)
            feet.push_back(units[static_cast<std::size_t>(unit)].base.z);
    }
    ASSERT_FALSE(feet.empty());
    const float depth = 2.4682f + 0.3667f * height; // of 18 m: half of the tree
    EXPECT_NEAR(*std::min_element(feet.begin(), feet.end()), height - depth, 1.0f);
}

TEST(GrowthLaws, LeafAreaOfAForestTreeFollowsItsTrunk) {
    const Species oak = withForestCrown("oak");
    const TreeModel open = makeTreeModel(growthOf(oak, true)), forest = makeTreeModel(growthOf(oak, false));
    EXPECT_EQ(open.leaves.size(), forest.leaves.size());
    const auto area = [](const TreeModel& model) {
        float sum = 0.0f;
        for (const LeafCluster& leaf : model.leaves)
            sum += leaf.size * leaf.size;
        return sum * glm::distance(model.leafMesh[0].corner, model.leafMesh[1].corner) *
               glm::distance(model.leafMesh[1].corner, model.leafMesh[2].corner);
    };
    EXPECT_NEAR(area(forest) / area(open), trunkSection(forest.skeleton) / trunkSection(open.skeleton),
                0.01f);
}

TEST(GrowthLaws, ForestShadesTreesThatGrowByLight) {
    EXPECT_TRUE(growsByLight(*findSpecies("oak")));
    EXPECT_FALSE(growsByLight(*findSpecies("palm")));
    EXPECT_FALSE(growsByLight({})) << "a tree built of levels";
    EXPECT_EQ(growthOf(*findSpecies("oak"), true).growth->site.shade, 0.0f);
    EXPECT_GT(growthOf(*findSpecies("oak"), false).growth->site.shade, 0.2f);
}

TEST(GrowthLaws, StoutTreesHaveSofterWood) {
    WoodParameters wood;
    wood.elasticModulus = 10.0e9f;
    wood.modulusPower = 0.78f;
    EXPECT_NEAR(stemModulus(wood, 80.0) / 10.0e9, 1.0, 1e-6);
    EXPECT_NEAR(stemModulus(wood, 100.0) / stemModulus(wood, 60.0), std::pow(100.0 / 60.0, 0.78), 1e-4);
}

TEST(GrowthLaws, ModulusIsConstantBeyondTheMeasuredSlenderness) {
    WoodParameters wood;
    wood.modulusPower = 0.78f;
    EXPECT_EQ(stemModulus(wood, 10.0), stemModulus(wood, 50.0));
    EXPECT_EQ(stemModulus(wood, 400.0), stemModulus(wood, 110.0));
}

TEST(GrowthLaws, LivingStemsAreSofterThanClearWood) {
    WoodParameters wood;
    const double clear = stemModulus(wood, 80.0);
    wood.wholeStem = 0.85f;
    EXPECT_NEAR(stemModulus(wood, 80.0) / clear, 0.85, 1e-6);
    // Over bark: young Sitka spruces have 2.0 to 6.4 GPa (Milne and Blackburn 1989), large Norway
    // spruces 10.6 to 15.6 (Lundström et al. 2008).
    const WoodParameters spruce = findSpecies("Norway spruce")->wood;
    const double overBark = stemModulus(spruce, 80.0) * std::pow(spruce.underBark, 4.0);
    EXPECT_GT(overBark, 2.0e9);
    EXPECT_LT(overBark, 10.6e9);
}

namespace {

constexpr double heavyTrunk = 1.0e6; // kg, more than any stem

/// Wood of which `density` dry kg are in a fresh m^3.
WoodParameters dryWood(WoodAllometry allometry, float density) {
    WoodParameters wood;
    wood.branchWood = allometry;
    wood.density = density;
    return wood;
}

} // namespace

TEST(GrowthLaws, BranchMassOfConifersMatchesWeighedTrees) {
    // Geometric means of trees of BAAD (Falster et al. 2015): diameter, height, dry branches.
    const WoodParameters wood = dryWood(WoodAllometry::Conifer, 400.0f);
    const auto expectNear = [&](double diameter, double height, double measured) {
        EXPECT_NEAR(std::log(branchWoodMass(wood, diameter, height, heavyTrunk, 5.0) / measured), 0.0, 0.25)
            << measured << " kg";
    };
    expectNear(0.207, 18.7, 13.5); // 140 Norway spruces, Burger 1953
    expectNear(0.236, 16.0, 27.4); // 88 of ten conifers, Brown 1978
    expectNear(0.356, 26.7, 80.7); // 57 pines and Douglas firs, Monserud and Marshall 1999
    expectNear(0.306, 28.7, 36.4); // 24 Norway spruces, Kantola and Makela 2004
}

TEST(GrowthLaws, BranchMassOfBroadleavesMatchesWeighedTrees) {
    // Geometric means of the five largest studies of broadleaves in BAAD, trees of 5 cm or more.
    const WoodParameters wood = dryWood(WoodAllometry::Broadleaf, 580.0f);
    const auto expectNear = [&](double diameter, double height, double measured) {
        EXPECT_NEAR(std::log(branchWoodMass(wood, diameter, height, heavyTrunk, measured) / measured), 0.0,
                    0.6)
            << measured << " kg";
    };
    expectNear(0.111, 16.8, 2.6);  // 143 planted eucalypts, Epron et al. 2012
    expectNear(0.113, 10.4, 5.4);  // 130 of a young forest in Panama, van Breugel et al. 2011
    expectNear(0.134, 9.1, 21.3);  // 98 of open eucalypt woods, Williams et al. 2005
    expectNear(0.099, 11.2, 3.3);  // 83 of a forest of Sanbe, Katagiri et al. 1984
    expectNear(0.142, 13.8, 10.4); // 74 of forests of Hida, Komiyama et al. 2002
}

TEST(GrowthLaws, SlenderTreesHaveLittleBranchMass) {
    WoodParameters wood;
    wood.branchWood = WoodAllometry::Conifer;
    const auto mass = [&](double diameter, double height) {
        return branchWoodMass(wood, diameter, height, heavyTrunk, 5.0);
    };
    EXPECT_NEAR(mass(0.2, 24.0) / mass(0.2, 12.0), std::pow(2.0, -0.91), 1e-9);
    EXPECT_EQ(mass(0.1, 20.0), mass(0.1, 15.0)); // the limit of the weighed trees
    EXPECT_EQ(mass(0.0, 0.0), 0.0);
}

TEST(GrowthLaws, LimbsOfADividedTrunkHaveTheMassOfItsStem) {
    // A stem of 20 m with the radius (H - z)^0.6, sliced.
    const double height = 20.0, diameter = 0.3, step = 1e-3;
    double stem = 0.0; // kg
    for (double z = 0.5 * step; z < height; z += step)
        stem += 900.0 * 0.25 * 3.141592653589793 * diameter * diameter *
                std::pow((height - z) / (height - 1.3), 1.2) * step;
    WoodParameters wood = dryWood(WoodAllometry::Conifer, 900.0f);
    const auto mass = [&](double trunk) { return branchWoodMass(wood, diameter, height, trunk, 100.0); };
    EXPECT_NEAR(mass(0.6 * stem) - mass(stem), 0.4 * stem, 1e-3 * stem);
    EXPECT_NEAR(mass(1.5 * stem) - mass(stem), 0.0, 1e-3 * stem);
}

TEST(GrowthLaws, TrunkAndBranchesOfABroadleafHaveAtLeastTheWeighedMass) {
    // Jenkins et al. 2003, hard maple, oak, hickory and beech of 50 cm: 1826 kg dry, 1/53 of it leaves.
    const WoodParameters wood = dryWood(WoodAllometry::Broadleaf, 1000.0f);
    const double total = branchWoodMass(wood, 0.5, 20.0, 1000.0, 1500.0) + 1000.0;
    EXPECT_NEAR(total / 1000.0 * 580.0, 1826.0 * (1.0 - 1.0 / 53.0), 20.0);
}

TEST(GrowthLaws, BranchMassOfBroadleavesIsWithinAThirdAndThreeTimesTheDrawn) {
    const WoodParameters wood = dryWood(WoodAllometry::Broadleaf, 1000.0f);
    EXPECT_EQ(branchWoodMass(wood, 0.3, 20.0, 900.0, 3000.0), 1000.0);
    EXPECT_EQ(branchWoodMass(wood, 0.3, 20.0, 10.0, 100.0), 300.0);
}

TEST(GrowthLaws, RootsTurnAQuarterOfADegreeUnderASmallLoad) {
    // 1/2.5 of the overturning moment, 150 N m per kg of a stem of 0.45 pi/4 d^2 h.
    WoodParameters wood;
    EXPECT_EQ(rootCompliance(wood, 0.3, 20.0), 0.0);
    wood.anchorage = 150.0f;
    const double stem = 0.45 * 900.0 * 3.141592653589793 * 0.0225 * 20.0;
    EXPECT_NEAR(rootCompliance(wood, 0.3, 20.0) * 0.4 * 150.0 * stem * 180.0 / 3.141592653589793, 0.25, 1e-9);
}
