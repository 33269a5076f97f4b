// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/BuiltInSpecies.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cctype>
#include <set>

using namespace osgTreeWind;

TEST(BuiltInSpecies, ThereAreAtLeastTwelveAndEachHasASource) {
    const auto all = builtInSpecies();
    std::size_t conifers = 0;
    for (const BuiltInSpecies& built : all) {
        EXPECT_FALSE(built.source.empty()) << built.species.name;
        conifers += built.species.appearance.needles();
    }
    EXPECT_GE(all.size(), 12u);
    EXPECT_GE(conifers, 5u);
    EXPECT_GE(all.size() - conifers, 5u);
}

TEST(BuiltInSpecies, NoTwoShareAName) {
    std::set<std::string> names;
    for (const BuiltInSpecies& built : builtInSpecies())
        for (std::string name : built.names) {
            for (char& c : name)
                c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            EXPECT_TRUE(names.insert(name).second) << name;
        }
}

TEST(BuiltInSpecies, AreFoundByCommonAndScientificNameInAnyCase) {
    ASSERT_TRUE(findBuiltInSpecies("oak"));
    EXPECT_EQ(findBuiltInSpecies("QUERCUS ROBUR")->name, "oak");
    EXPECT_EQ(findBuiltInSpecies("Picea abies")->name, "Norway spruce");
    EXPECT_FALSE(findBuiltInSpecies("lamp post"));
    EXPECT_FALSE(findBuiltInSpecies(""));
    EXPECT_EQ(defaultSpecies().name, "broadleaf");
}

TEST(BuiltInSpecies, ModuliAreThoseOfTheTable) {
    // ForestGALES: Sitka spruce 5.9 GPa, C 2.35, n 0.51; beech 9.8 GPa, C 2.4141, n 0.904.
    const Species sitka = *findBuiltInSpecies("Sitka spruce"), beech = *findBuiltInSpecies("beech");
    EXPECT_FLOAT_EQ(sitka.wood.elasticModulus, 5.9e9f);
    EXPECT_FLOAT_EQ(sitka.wood.crownDrag, 2.35f);
    EXPECT_FLOAT_EQ(sitka.wood.streamlining, 0.51f);
    EXPECT_FLOAT_EQ(beech.wood.elasticModulus, 9.8e9f);
    EXPECT_NEAR(beech.wood.crownDrag, 2.4141f, 1e-3f);
    EXPECT_FLOAT_EQ(beech.wood.streamlining, 0.904f);
}

TEST(BuiltInSpecies, ConifersHaveTheVolumesOfForestry) {
    // Stem over trunk section at breast height times height: 0.4 to 0.5 (form factor); branches 0.15 to 0.2
    // of the wood (Jenkins et al. 2003).
    for (const BuiltInSpecies& built : builtInSpecies()) {
        if (!built.species.appearance.needles())
            continue;
        const TreeModel model = makeTreeModel(built.species.tree, 0);
        const TreeScale scale = fitTree(model, {20.0f, 0.3f, 0.0f});
        double stem = 0.0, branches = 0.0;
        for (const BranchUnit& unit : model.skeleton.units) {
            const double a = unit.baseRadius * scale.radius, b = unit.tipRadius * scale.radius;
            const double length = glm::length(scale.axes * (unit.tip - unit.base));
            (unit.level == 0 ? stem : branches) += 3.141592653589793 / 3.0 * length * (a * a + a * b + b * b);
        }
        const double form = stem / (3.141592653589793 * 0.15 * 0.15 * 20.0);
        EXPECT_GT(form, 0.4) << built.species.name;
        EXPECT_LT(form, 0.5) << built.species.name;
        EXPECT_GT(branches / (stem + branches), 0.15) << built.species.name;
        EXPECT_LT(branches / (stem + branches), 0.2) << built.species.name;
    }
}

TEST(BuiltInSpecies, CrownsOfTownTreesAre22To28TimesAsWideAsTheirStems) {
    // Coombes, Martin, Slater 2019.
    for (const char* name : {"oak", "sycamore", "silver birch", "Norway maple"}) {
        float sum = 0.0f;
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeSize size = measureTree(makeTreeModel(findBuiltInSpecies(name)->tree, shape));
            sum += size.crownWidth / size.trunkDiameter / 3.0f;
        }
        EXPECT_GT(sum, 22.0f) << name;
        EXPECT_LT(sum, 28.0f) << name;
    }
}

TEST(BuiltInSpecies, LeavesDrawnHaveTheAreaOfTheMechanics) {
    for (const BuiltInSpecies& built : builtInSpecies()) {
        const TreeModel model = makeTreeModel(built.species.tree);
        const float card = glm::distance(model.leafMesh[0].corner, model.leafMesh[1].corner) *
                           glm::distance(model.leafMesh[1].corner, model.leafMesh[2].corner);
        float drawn = 0.0f;
        for (const LeafCluster& leaf : model.leaves)
            drawn += quadsPerLeafCluster * leaf.size * leaf.size * card;
        drawn *= leafCoverage(built.species.appearance.leafForm);
        EXPECT_NEAR(drawn / leafArea(model, {}, built.species), 1.0f, 0.2f) << built.species.name;
    }
}

TEST(BuiltInSpecies, AreCheapEnoughToDraw) {
    for (const BuiltInSpecies& built : builtInSpecies())
        for (std::uint32_t shape = 0; shape < 3; ++shape) {
            const TreeModel model = makeTreeModel(built.species.tree, shape);
            EXPECT_LE(model.skeleton.units.size(), 300u) << built.species.name;
            EXPECT_LE(model.leaves.size(), 1900u) << built.species.name;
        }
}

TEST(BuiltInSpecies, TreesOfACampusFindTheirKind) {
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
        ASSERT_TRUE(findBuiltInSpecies(name)) << name;
        EXPECT_EQ(findBuiltInSpecies(name)->name, kind) << name;
    }
}
