// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/BuiltInSpecies.h>

#include <gtest/gtest.h>

#include <cctype>
#include <set>

using namespace osgTreeWind;

TEST(BuiltInSpecies, ThereAreAtLeastTwelveAndEachHasASource) {
    const auto all = builtInSpecies();
    std::size_t conifers = 0;
    for (const BuiltInSpecies& built : all) {
        EXPECT_FALSE(built.source.empty()) << built.species.name;
        conifers += built.species.appearance.needles;
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
