// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/gtc/constants.hpp>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// A trunk of 4 m and 20 cm with two branches of half its diameter; the second has no leaves.
TreeModel twoBranches() {
    TreeModel model;
    model.skeleton.units = {{-1, 0, {0, 0, 0}, {0, 0, 4}, 0.1f, 0.1f},
                            {0, 1, {0, 0, 4}, {2, 0, 4}, 0.05f, 0.05f},
                            {0, 1, {0, 0, 4}, {-2, 0, 4}, 0.05f, 0.05f}};
    model.leaves.resize(2);
    model.leaves[0].unit = model.leaves[1].unit = 1;
    model.leaves[0].anchor = {-1, -1, 3};
    model.leaves[1].anchor = {1, 1, 7};
    return model;
}

} // namespace

TEST(UnitLoads, LeafAreaFollowsTheTrunkSection) {
    const Species species;
    const auto loads = makeUnitLoads(twoBranches(), {}, species);
    const float area = species.wood.leafArea * glm::pi<float>() * 0.01f;
    EXPECT_EQ(loads[0].leafMass, 0.0f);
    EXPECT_NEAR(loads[1].leafMass, species.wood.leafMass * area, 1e-3f);
    EXPECT_NEAR(loads[1].leafDrag, species.wood.leafDrag * area, 1e-3f);
    EXPECT_EQ(loads[2].leafMass, 0.0f);
}

TEST(UnitLoads, WoodDragFollowsItsOutline) {
    const auto loads = makeUnitLoads(twoBranches(), {}, Species());
    EXPECT_NEAR(loads[0].woodDrag, 0.8f, 1e-6f);
    EXPECT_NEAR(loads[1].woodDrag, 0.2f, 1e-6f);
}

TEST(UnitLoads, AMeasuredCrownIncludesItsBranches) {
    Species species;
    species.wood.crownDrag = 2.0f;
    const auto loads = makeUnitLoads(twoBranches(), {}, species);
    EXPECT_NEAR(loads[0].woodDrag, 0.8f, 1e-6f);
    EXPECT_EQ(loads[1].woodDrag, 0.0f);
    EXPECT_NEAR(loads[1].leafDrag, 2.0f * 0.25f * (2.0f + 2.0f) * 4.0f, 1e-4f); // a rhombus
}

TEST(UnitLoads, JointStiffnessUsesTheReachToTheAxisTip) {
    TreeModel model = twoBranches();
    model.skeleton.units.insert(model.skeleton.units.begin(), {-1, 0, {0, 0, -4}, {0, 0, 0}, 0.1f, 0.1f});
    for (std::size_t i = 1; i < model.skeleton.units.size(); ++i)
        ++model.skeleton.units[i].parent;
    const auto loads = makeUnitLoads(model, {}, Species());
    const float lengths[]{4, 4, 2, 2}, reaches[]{8, 4, 2, 2}, diameters[]{0.2f, 0.2f, 0.1f, 0.1f};
    for (std::size_t i = 0; i < loads.size(); ++i)
        EXPECT_NEAR(loads[i].stiffness /
                        jointStiffness(9.0e9, diameters[i], diameters[i], lengths[i], reaches[i]),
                    1.0, 1e-5);
}

TEST(UnitLoads, JointsOfAnAxisDeflectLikeABeamUnderATipForce) {
    // A uniform pole of three units: together they must deflect the tip by F L^3 / (3 E I).
    double shift = 0.0;
    for (const double base : {0.0, 2.0, 5.0}) {
        const double length = base == 0.0 ? 2.0 : base == 2.0 ? 3.0 : 5.0, reach = 10.0 - base;
        shift += reach * reach / jointStiffness(1.0e10, 0.2, 0.2, length, reach);
    }
    EXPECT_NEAR(shift / (1000.0 / (3.0 * 1.0e10 * glm::pi<double>() * std::pow(0.2, 4) / 64.0)), 1.0, 1e-9);
}

TEST(UnitLoads, WoodMassIsThatOfTheUnits) {
    const auto loads = makeUnitLoads(twoBranches(), {}, Species());
    EXPECT_NEAR(loads[0].woodMass, 900.0f * glm::pi<float>() * 0.01f * 4.0f, 1e-3f);
    EXPECT_NEAR(loads[1].woodMass, 900.0f * glm::pi<float>() * 0.0025f * 2.0f, 1e-3f);
}

TEST(UnitLoads, OnlyTheTrunkHasRootCompliance) {
    Species species;
    const auto rigid = makeUnitLoads(twoBranches(), {}, species);
    species.wood.anchorage = 150.0f;
    const auto loads = makeUnitLoads(twoBranches(), {}, species);
    EXPECT_EQ(rigid[0].rootCompliance, 0.0f);
    EXPECT_GT(loads[0].rootCompliance, 0.0f);
    EXPECT_EQ(loads[1].rootCompliance, 0.0f);
    EXPECT_NEAR(1.0f / loads[0].stiffness, 1.0f / rigid[0].stiffness + loads[0].rootCompliance,
                1e-5f / rigid[0].stiffness);
    EXPECT_EQ(loads[1].stiffness, rigid[1].stiffness);
}

TEST(UnitLoads, BranchesMayBeSofterThanTheirTrunk) {
    Species species;
    const auto even = makeUnitLoads(twoBranches(), {}, species);
    species.wood.branchModulus = 0.5f;
    const auto loads = makeUnitLoads(twoBranches(), {}, species);
    EXPECT_EQ(loads[0].stiffness, even[0].stiffness);
    EXPECT_NEAR(loads[1].stiffness / even[1].stiffness, 0.5f, 1e-5f);
}

TEST(UnitLoads, BranchesHaveTheWoodOfTheAllometry) {
    Species species;
    species.wood.branchWood = WoodAllometry::Conifer;
    const auto drawn = makeUnitLoads(twoBranches(), {}, Species()),
               loads = makeUnitLoads(twoBranches(), {}, species);
    EXPECT_EQ(loads[0].woodMass, drawn[0].woodMass);
    EXPECT_NEAR(loads[1].woodMass + loads[2].woodMass,
                branchWoodMass(species.wood, 0.2, twoBranches().skeleton.height(), drawn[0].woodMass, 0.0),
                1e-3);
    // A drawn branch represents several, side by side.
    EXPECT_NEAR(loads[1].modulus / drawn[1].modulus, loads[1].woodMass / drawn[1].woodMass, 1e-4f);
    species.wood.branchWood = WoodAllometry::Broadleaf;
    EXPECT_EQ(makeUnitLoads(twoBranches(), {}, species)[1].modulus, drawn[1].modulus);
}

TEST(UnitLoads, FollowTheSizeOfTheTree) {
    // Twice as large: four times the leaves and the outline; bare, eight times the stiffness.
    Species species = *findSpecies("oak");
    species.wood.branchWood = WoodAllometry::Drawn;
    species.wood.anchorage = 0.0f;
    const TreeModel model = makeTreeModel(species.tree, 0);
    TreeScale twice;
    twice.axes = glm::vec3(2.0f);
    twice.radius = 2.0f;
    const auto one = makeUnitLoads(model, {}, species), two = makeUnitLoads(model, twice, species);
    const auto bareOne = makeUnitLoads(model, {}, species, 0.0f),
               bareTwo = makeUnitLoads(model, twice, species, 0.0f);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_NEAR(two[i].leafDrag, 4.0f * one[i].leafDrag, 1e-3f * one[i].leafDrag);
        // The stiffness against its own weight grows by 16 (force by 8, arm by 2).
        const float stiffer = bareTwo[i].stiffness / bareOne[i].stiffness;
        EXPECT_GE(stiffer, 8.0f - 1e-2f);
        EXPECT_LE(stiffer, 16.0f + 1e-2f);
        if (model.skeleton.units[i].level == 0) {
            EXPECT_NEAR(stiffer, 8.0f, 1e-2f);
        }
    }
}

TEST(UnitLoads, ABareTreeHasTheDragOfItsWood) {
    Species species;
    species.wood.crownDrag = 2.0f;
    const auto full = makeUnitLoads(twoBranches(), {}, species),
               half = makeUnitLoads(twoBranches(), {}, species, 0.5f),
               bare = makeUnitLoads(twoBranches(), {}, species, 0.0f);
    EXPECT_EQ(bare[1].leafMass, 0.0f);
    EXPECT_EQ(bare[1].leafDrag, 0.0f);
    EXPECT_NEAR(bare[1].woodDrag, 0.2f, 1e-6f);
    EXPECT_NEAR(bare[0].woodDrag, full[0].woodDrag, 1e-6f);
    EXPECT_NEAR(half[1].leafMass, 0.5f * full[1].leafMass, 1e-3f);
    EXPECT_NEAR(half[1].leafDrag, 0.5f * full[1].leafDrag, 1e-3f);
    EXPECT_NEAR(half[1].woodDrag, 0.1f, 1e-6f);
    EXPECT_EQ(bare[1].stiffness, full[1].stiffness);
}

TEST(UnitLoads, SagOfAThinBranchDoesNotDependOnTheNumberOfUnits) {
    for (const int count : {1, 2, 8}) { // 8 m long, 2 cm thick: would hang down without its minimum stiffness
        TreeModel model;
        model.skeleton.units = {{-1, 0, {0, 0, 0}, {0, 0, 8}, 0.1f, 0.1f}};
        const float length = 8.0f / static_cast<float>(count);
        for (int i = 0; i < count; ++i) {
            const float x = length * static_cast<float>(i);
            model.skeleton.units.push_back({i, 1, {x, 0, 8}, {x + length, 0, 8}, 0.01f, 0.01f});
        }
        const auto loads = makeUnitLoads(model, {}, Species());
        float sag = 0.0f;
        for (std::size_t i = 1; i < loads.size(); ++i) {
            float moment = 0.0f;
            for (std::size_t carried = i; carried < loads.size(); ++carried)
                moment += 9.81f * loads[carried].woodMass * length * (static_cast<float>(carried - i) + 0.5f);
            sag += moment / loads[i].stiffness;
        }
        EXPECT_LE(sag, 0.351f) << count;
        EXPECT_GT(sag, 0.1f) << count;
    }
}
