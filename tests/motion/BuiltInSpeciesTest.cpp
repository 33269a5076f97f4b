// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/BuiltInSpecies.h>

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
