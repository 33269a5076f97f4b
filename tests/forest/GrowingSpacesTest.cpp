// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/GrowingSpaces.h>
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace osgTreeWind;

namespace {

TreePlacement treeAt(double x, double y, float height = 15.0f) {
    TreePlacement tree;
    tree.position = {x, y, 0.0};
    tree.size = {height, 0.3f, 5.0f};
    tree.heading = 0.7f;
    return tree;
}

/// A forest of a species that grows by light.
ForestDescription forestOf(std::vector<TreePlacement> trees) {
    ForestDescription forest;
    forest.species = {Species()};
    forest.species.front().tree.growth = GrowthParameters();
    forest.species.front().shapes = 8;
    forest.trees = std::move(trees);
    return forest;
}

std::vector<TreePlacement> withGrowingSpaces(std::vector<TreePlacement> trees,
                                             DerivedTreeValues derived = {}) {
    ForestDescription forest = forestOf(std::move(trees));
    findGrowingSpaces(forest, std::vector<DerivedTreeValues>(forest.trees.size(), derived));
    return forest.trees;
}

/// A square stand of 11 by 11 trees, 6 m apart and centred at the origin.
std::vector<TreePlacement> wood() {
    std::vector<TreePlacement> trees;
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y)
            trees.push_back(treeAt(6.0 * x, 6.0 * y));
    return trees;
}

const TreePlacement& at(const std::vector<TreePlacement>& trees, int x, int y) {
    return trees[static_cast<std::size_t>(11 * (x + 5) + y + 5)];
}

} // namespace

TEST(GrowingSpaces, IsolatedTreesAreOpenGrown) {
    const auto trees = withGrowingSpaces({treeAt(0, 0), treeAt(40, 0), treeAt(80, 10), treeAt(82, 10, 3.0f)});
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(trees[i].openGrown) << i << ": a 3 m tree does not shade a 15 m tree";
    EXPECT_EQ(trees[0].heading, 0.7f);
}

TEST(GrowingSpaces, OutermostTreesOfAStandAreAtItsEdge) {
    const auto trees = withGrowingSpaces(wood());
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y) {
            SCOPED_TRACE(testing::Message() << x << ", " << y);
            const TreePlacement& tree = at(trees, x, y);
            const bool isOutermost = std::max(std::abs(x), std::abs(y)) == 5;
            EXPECT_FALSE(tree.openGrown);
            EXPECT_EQ(tree.atEdge, isOutermost);
            if (!isOutermost) {
                EXPECT_EQ(tree.heading, 0.7f);
            }
        }
}

TEST(GrowingSpaces, EdgeTreesFaceTheirOpenSide) {
    const auto trees = withGrowingSpaces(wood());
    const auto normalized = [](float heading) { return std::remainder(heading, glm::two_pi<float>()); };
    EXPECT_NEAR(normalized(at(trees, 5, 0).heading), 0.0f, 0.01f);
    EXPECT_NEAR(normalized(at(trees, 0, 5).heading), glm::half_pi<float>(), 0.01f);
    EXPECT_NEAR(std::abs(normalized(at(trees, -5, 0).heading)), glm::pi<float>(), 0.01f);
    EXPECT_NEAR(normalized(at(trees, 5, 5).heading), glm::radians(45.0f), 0.05f);
}

TEST(GrowingSpaces, TreesOfARowAreOpenGrown) {
    std::vector<TreePlacement> row;
    for (int i = 0; i < 20; ++i)
        row.push_back(treeAt(9.0 * i, 0));
    const auto trees = withGrowingSpaces(row);
    for (std::size_t i = 1; i + 1 < trees.size(); ++i) {
        EXPECT_TRUE(trees[i].openGrown) << i;
        EXPECT_FALSE(trees[i].atEdge) << i;
    }
}

TEST(GrowingSpaces, ValuesSetByTheFileAreKept) {
    DerivedTreeValues fixedSpace;
    fixedSpace.growingSpace = false;
    const auto before = wood(), after = withGrowingSpaces(before, fixedSpace);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_FALSE(after[i].openGrown || after[i].atEdge);
        EXPECT_EQ(after[i].heading, before[i].heading);
    }
    DerivedTreeValues fixedHeading;
    fixedHeading.heading = false;
    for (const TreePlacement& tree : withGrowingSpaces(before, fixedHeading)) {
        EXPECT_FALSE(tree.atEdge) << "it would have to be rotated";
        EXPECT_EQ(tree.heading, 0.7f);
    }
}

TEST(GrowingSpaces, OnlySpeciesThatGrowByLightAreAffected) {
    ForestDescription forest = forestOf({treeAt(0, 0)});
    forest.species.front().tree.growth.reset();
    findGrowingSpaces(forest, {DerivedTreeValues()});
    EXPECT_FALSE(forest.trees.front().openGrown);
}

TEST(GrowingSpaces, CoincidentTreesWithoutSizesAreNeighbours) {
    TreePlacement sizeless;
    const auto trees = withGrowingSpaces({sizeless, sizeless, sizeless});
    for (const TreePlacement& tree : trees)
        EXPECT_FALSE(tree.openGrown);
    EXPECT_TRUE(withGrowingSpaces({sizeless}).front().openGrown);
}

TEST(GrowingSpaces, NeighboursGetDifferentShapes) {
    ForestDescription forest = forestOf(wood());
    const std::vector<DerivedTreeValues> derived(forest.trees.size());
    findGrowingSpaces(forest, derived);
    for (std::size_t i = 0; i < forest.trees.size(); ++i)
        forest.trees[i].seed = static_cast<std::uint32_t>(7 * i * i);
    const auto equalNeighbours = [&] { // ordered pairs of neighbours with the same shape
        const ShapeFamilies families(forest);
        const auto shapeOf = [&](const TreePlacement& tree) {
            const std::size_t family = families.indexOf(tree);
            return std::make_pair(family, tree.seed % families.all()[family].shapes);
        };
        int count = 0;
        for (const TreePlacement& a : forest.trees)
            for (const TreePlacement& b : forest.trees)
                count += &a != &b && glm::distance(a.position, b.position) < 7.0 && shapeOf(a) == shapeOf(b);
        return count;
    };
    EXPECT_GT(equalNeighbours(), 40);
    varyNeighbourSeeds(forest, ShapeFamilies(forest), derived);
    EXPECT_EQ(equalNeighbours(), 0);
    DerivedTreeValues fixedSeed;
    fixedSeed.seed = false;
    const std::uint32_t before = forest.trees[60].seed = forest.trees[59].seed;
    varyNeighbourSeeds(forest, ShapeFamilies(forest),
                       std::vector<DerivedTreeValues>(forest.trees.size(), fixedSeed));
    EXPECT_EQ(forest.trees[60].seed, before) << "the file sets it";
}

TEST(GrowingSpaces, LargestSeedsDoNotOverflow) {
    ForestDescription forest = forestOf({treeAt(0, 0), treeAt(5, 0)});
    forest.trees[0].seed = forest.trees[1].seed = std::numeric_limits<std::uint32_t>::max();
    varyNeighbourSeeds(forest, ShapeFamilies(forest), std::vector<DerivedTreeValues>(2));
    EXPECT_NE(forest.trees[0].seed % 8, forest.trees[1].seed % 8);
}
