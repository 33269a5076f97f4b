// SPDX-License-Identifier: MIT
// Built-in species beside measurements of trees: what photographs of crowns show of the sky (Wilkinson 1992),
// crowns over stems (Coombes, Martin, Slater 2019), inclinations of leaves (Chianucci et al. 2018).
#include <osgTreeWind/nodes/TreeLooks.h>

#include <osgTreeWind/motion/BuiltInSpecies.h>

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

namespace osgTreeWind {
namespace {

struct Measured {
    const char* species;
    std::optional<float> summer, winter; ///< Share of the sky.
    std::optional<float> inclination;    ///< Degrees.
    bool crown;                          ///< Whether 22 to 28 stems wide.
};

void PrintTo(const Measured& measured, std::ostream* out) {
    *out << measured.species;
}

class TreeLooksOf : public testing::TestWithParam<Measured> {};

TEST_P(TreeLooksOf, AreThoseOfMeasuredTrees) {
    const Measured& tree = GetParam();
    const TreeLooks looks = measureLooks(*findBuiltInSpecies(tree.species));
    if (tree.summer) {
        EXPECT_NEAR(looks.skyThroughCrownSummer, *tree.summer, 0.06f);
    }
    if (tree.winter) {
        EXPECT_NEAR(looks.skyThroughCrownWinter, *tree.winter, 0.08f);
    }
    if (tree.inclination) {
        EXPECT_NEAR(looks.leafInclination, *tree.inclination, 5.0f);
    }
    if (tree.crown) {
        EXPECT_GE(looks.crownOverStem, 22.0f);
        EXPECT_LE(looks.crownOverStem, 28.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Species, TreeLooksOf,
    testing::Values(Measured{"oak", 0.17f, 0.50f, 35.0f, true}, Measured{"beech", 0.19f, 0.47f, 18.0f, false},
                    Measured{"birch", 0.24f, 0.54f, 56.0f, true}, Measured{"pine", 0.27f, {}, {}, false},
                    Measured{"ash", 0.22f, 0.53f, {}, false}, Measured{"lime", 0.11f, 0.54f, {}, false},
                    Measured{"sycamore", 0.18f, 0.54f, {}, true}, Measured{"poplar", 0.13f, 0.50f, {}, false},
                    Measured{"Norway maple", {}, {}, 27.0f, true}, Measured{"red oak", {}, {}, 27.0f, false},
                    Measured{"aspen", {}, {}, 37.0f, false}));

TEST(TreeLooks, LeavesAreDrawnAsTheMechanicsTakeThemAndNoCrownHasOneHue) {
    for (const BuiltInSpecies& built : builtInSpecies()) {
        const TreeLooks looks = measureLooks(built.species);
        EXPECT_NEAR(looks.leafAreaDrawn / looks.leafAreaMechanics, 1.0f, 0.2f) << built.species.name;
        EXPECT_GE(looks.hueSpread, 15.0f) << built.species.name;
    }
}

} // namespace
} // namespace osgTreeWind
