// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/model/WoodVolume.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

using namespace osgTreeWind;

TEST(BuiltInSpecies, HaveStrengthsOfGreenWood) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        if (species.name == "palm") // unknown
            continue;
        // Of all in the Wood Handbook: northern white cedar to shellbark hickory.
        EXPECT_GE(species.wood.bendingStrength, 29.0e6f) << species.name;
        EXPECT_LE(species.wood.bendingStrength, 72.0e6f) << species.name;
    }
}

TEST(BuiltInSpecies, AreAtLeastTwelveAndHaveSources) {
    const auto& all = SpeciesCatalogue::builtIn().species();
    std::size_t conifers = 0;
    for (const Species& species : all) {
        EXPECT_FALSE(species.source.empty()) << species.name;
        conifers += species.appearance.hasNeedles();
    }
    EXPECT_GE(all.size(), 12u);
    EXPECT_GE(conifers, 5u);
    EXPECT_GE(all.size() - conifers, 5u);
}

TEST(BuiltInSpecies, AreFoundByCommonAndScientificNameInAnyCase) {
    ASSERT_TRUE(findSpecies("oak"));
    EXPECT_EQ(findSpecies("QUERCUS ROBUR")->name, "oak");
    EXPECT_EQ(findSpecies("Picea abies")->name, "Norway spruce");
    EXPECT_FALSE(findSpecies("lamp post"));
    EXPECT_FALSE(findSpecies(""));
    EXPECT_EQ(defaultSpecies().name, "broadleaf");
}

TEST(BuiltInSpecies, HaveTheModuliOfTheTable) {
    // ForestGALES: Sitka spruce 5.9 GPa, C 2.35, n 0.51; beech 9.8 GPa, C 2.4141, n 0.904.
    const Species sitka = *findSpecies("Sitka spruce"), beech = *findSpecies("beech");
    EXPECT_FLOAT_EQ(sitka.wood.elasticModulus, 5.9e9f);
    EXPECT_FLOAT_EQ(sitka.wood.crownDrag, 2.35f);
    EXPECT_FLOAT_EQ(sitka.wood.streamlining, 0.51f);
    EXPECT_FLOAT_EQ(beech.wood.elasticModulus, 9.8e9f);
    EXPECT_NEAR(beech.wood.crownDrag, 2.4141f, 1e-3f);
    EXPECT_FLOAT_EQ(beech.wood.streamlining, 0.904f);
}

TEST(BuiltInSpecies, ConifersHaveStemAndBranchMassesOfForestry) {
    // In a stand: stem over trunk section at breast height times height 0.4 to 0.5 (form factor); branches
    // about 0.15 to 0.2 of the wood's mass (Jenkins et al. 2003).
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        if (!species.appearance.hasNeedles())
            continue;
        const TreeModel model = makeTreeModel(growthOf(species, false), 0);
        const TreeScale scale = fitTree(model, {20.0f, 0.3f, 0.0f});
        double stem = 0.0, stemMass = 0.0, branchMass = 0.0;
        const std::vector<UnitLoad> loads = makeUnitLoads(model, scale, species);
        for (std::size_t i = 0; i < loads.size(); ++i) {
            const BranchUnit& unit = model.skeleton.units[i];
            const double a = unit.baseRadius * scale.radius, b = unit.tipRadius * scale.radius;
            const bool isStem = unit.level == 0;
            if (isStem)
                stem += frustumVolume(glm::length(scale.axes * (unit.tip - unit.base)), a, b);
            (isStem ? stemMass : branchMass) += loads[i].woodMass;
            branchMass += loads[i].shootMass;
        }
        const double form = stem / (3.141592653589793 * 0.15 * 0.15 * 20.0);
        EXPECT_GT(form, 0.4) << species.name;
        EXPECT_LT(form, 0.5) << species.name;
        EXPECT_GT(branchMass / (stemMass + branchMass), 0.145) << species.name;
        EXPECT_LT(branchMass / (stemMass + branchMass), 0.2) << species.name;
    }
}

TEST(BuiltInSpecies, UrbanCrownsAre22To28TimesAsWideAsTheirStems) {
    // Coombes, Martin, Slater 2019.
    for (const char* name : {"oak", "sycamore", "silver birch", "Norway maple"}) {
        float sum = 0.0f;
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeSize size = measureTree(makeTreeModel(findSpecies(name)->tree, shape));
            sum += size.crownWidth / size.trunkDiameter / 3.0f;
        }
        EXPECT_GT(sum, 22.0f) << name;
        EXPECT_LT(sum, 28.0f) << name;
    }
}

TEST(BuiltInSpecies, DrawnLeavesHaveTheAreaOfTheMechanics) {
    for (const Species& species : SpeciesCatalogue::builtIn().species()) {
        const TreeModel model = makeTreeModel(species.tree);
        const float card = glm::distance(model.leafMesh[0].corner, model.leafMesh[1].corner) *
                           glm::distance(model.leafMesh[1].corner, model.leafMesh[2].corner);
        float drawn = 0.0f;
        for (const LeafCluster& leaf : model.leaves)
            drawn += quadsPerLeafCluster * leaf.size * leaf.size * card;
        drawn *= leafCoverage(species.appearance.leafForm) / flatLeafArea(species.appearance.leafForm);
        EXPECT_NEAR(drawn / leafArea(model, {}, species), 1.0f, 0.05f) << species.name;
    }
}

TEST(BuiltInSpecies, AreCheapEnoughToDraw) {
    for (const Species& species : SpeciesCatalogue::builtIn().species())
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeModel model = makeTreeModel(species.tree, shape);
            EXPECT_LE(model.skeleton.units.size(), 300u) << species.name;
            EXPECT_LE(model.leaves.size(), 3100u) << species.name;
        }
}

TEST(BuiltInSpecies, HaveFlaredTrunks) {
    const auto flare = [](const Species& species) {
        return species.tree.growth ? species.tree.growth->flare : species.tree.palm->flare;
    };
    for (const Species& species : SpeciesCatalogue::builtIn().species())
        EXPECT_GT(flare(species), 0.2f) << species.name;
    EXPECT_GT(flare(*findSpecies("beech")), flare(*findSpecies("silver birch")));
    EXPECT_GT(flare(*findSpecies("oak")), flare(*findSpecies("palm")));
}

TEST(BuiltInSpecies, TreesOfACampusAreMatched) {
    // What botanists call the trees of the University of Utah.
    const std::vector<std::pair<const char*, const char*>> kinds = {
        {"Gleditsia triacanthos", "honey locust"},
        {"Pinus nigra", "Corsican pine"},
        {"Acer saccharinum", "red maple"},
        {"Platanus x acerifolia", "London plane"},
        {"Pyrus spp.", "broadleaf"},
        {"Picea pungens", "white spruce"},
        {"Acer platanoides", "Norway maple"},
        {"Malus spp.", "broadleaf"},
        {"Quercus macrocarpa", "oak"},
        {"Fagus sylvatica", "beech"},
        {"Zelkova serrata", "broadleaf"},
        {"Fraxinus pennsylvanica", "ash"},
        {"Pseudotsuga menziesii", "Douglas fir"},
        {"Morus alba", "broadleaf"},
        {"Prunus spp.", "broadleaf"},
        {"Tilia cordata", "linden"},
        {"Ulmus pumila", "broadleaf"},
        {"Aesculus hippocastanum", "horse chestnut"},
        {"Pinus ponderosa", "Corsican pine"},
        {"Betula pendula", "silver birch"},
        {"Koelreuteria paniculata", "broadleaf"},
        {"Crataegus x lavallei", "broadleaf"},
        {"Cercis canadensis", "broadleaf"},
        {"Gymnocladus dioicus", "honey locust"},
        {"Populus sargentii", "aspen"},
        {"Juniperus virginiana", "conifer"},
        {"Carpinus betulus 'Fastigiata'", "broadleaf"},
        {"Robinia pseudoacacia", "honey locust"},
        {"Rhus lancea", "broadleaf"},
        {"Ginkgo biloba", "ginkgo"},
        {"Cedrus deodara", "conifer"},
        {"Magnolia grandiflora", "broadleaf"},
        {"Liriodendron tulipifera", "broadleaf"},
        {"Liquidambar styraciflua", "broadleaf"}};
    for (const auto& [name, kind] : kinds) {
        ASSERT_TRUE(findSpecies(name)) << name;
        EXPECT_EQ(findSpecies(name)->name, kind) << name;
    }
}
