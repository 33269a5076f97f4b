// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CompanyOfTrees.h>
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

ForestDescription growing(std::vector<TreePlacement> trees) {
    ForestDescription forest;
    forest.species = {Species()};
    forest.species.front().tree.growth = GrowthParameters();
    forest.species.front().shapes = 8;
    forest.trees = std::move(trees);
    return forest;
}

std::vector<TreePlacement> settled(std::vector<TreePlacement> trees, UnsaidOfTree unsaid = {}) {
    ForestDescription forest = growing(std::move(trees));
    findCompany(forest, std::vector<UnsaidOfTree>(forest.trees.size(), unsaid));
    return forest.trees;
}

/// A square wood of 11 by 11 trees, the middle one at the origin, 6 m apart.
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

TEST(CompanyOfTrees, OneThatStandsByItselfIsInTheOpen) {
    const auto trees = settled({treeAt(0, 0), treeAt(40, 0), treeAt(80, 10), treeAt(82, 10, 3.0f)});
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(trees[i].openGrown) << i << ": a tree of 3 m is no neighbour of one of 15";
    EXPECT_EQ(trees[0].heading, 0.7f);
}

TEST(CompanyOfTrees, OfAWoodTheOutermostTreesAreItsEdge) {
    const auto trees = settled(wood());
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y) {
            SCOPED_TRACE(testing::Message() << x << ", " << y);
            const TreePlacement& tree = at(trees, x, y);
            const bool outermost = std::max(std::abs(x), std::abs(y)) == 5;
            EXPECT_FALSE(tree.openGrown);
            EXPECT_EQ(tree.atEdge, outermost);
            if (!outermost) {
                EXPECT_EQ(tree.heading, 0.7f);
            }
        }
}

TEST(CompanyOfTrees, AtAnEdgeATreeIsTurnedToItsOpenSide) {
    const auto trees = settled(wood());
    const auto offEast = [](float heading) { return std::remainder(heading, glm::two_pi<float>()); };
    EXPECT_NEAR(offEast(at(trees, 5, 0).heading), 0.0f, 0.01f);
    EXPECT_NEAR(offEast(at(trees, 0, 5).heading), glm::half_pi<float>(), 0.01f);
    EXPECT_NEAR(std::abs(offEast(at(trees, -5, 0).heading)), glm::pi<float>(), 0.01f);
    EXPECT_NEAR(offEast(at(trees, 5, 5).heading), glm::radians(45.0f), 0.05f);
}

TEST(CompanyOfTrees, OfARowNoTreeIsAtAnEdge) {
    std::vector<TreePlacement> row;
    for (int i = 0; i < 20; ++i)
        row.push_back(treeAt(9.0 * i, 0));
    const auto trees = settled(row);
    for (std::size_t i = 1; i + 1 < trees.size(); ++i) {
        EXPECT_TRUE(trees[i].openGrown) << i;
        EXPECT_FALSE(trees[i].atEdge) << i;
    }
}

TEST(CompanyOfTrees, WhatIsSaidStays) {
    UnsaidOfTree all;
    all.company = false;
    const auto before = wood(), said = settled(before, all);
    for (std::size_t i = 0; i < said.size(); ++i) {
        EXPECT_FALSE(said[i].openGrown || said[i].atEdge);
        EXPECT_EQ(said[i].heading, before[i].heading);
    }
    UnsaidOfTree company;
    company.heading = false;
    for (const TreePlacement& tree : settled(before, company)) {
        EXPECT_FALSE(tree.atEdge) << "it would have to be turned";
        EXPECT_EQ(tree.heading, 0.7f);
    }
}

TEST(CompanyOfTrees, OnlyTreesThatGrowByLightHaveCompany) {
    ForestDescription forest = growing({treeAt(0, 0)});
    forest.species.front().tree.growth.reset();
    findCompany(forest, {UnsaidOfTree()});
    EXPECT_FALSE(forest.trees.front().openGrown);
}

TEST(CompanyOfTrees, TreesAtOnePlaceAndWithoutSizesAreFound) {
    TreePlacement small;
    const auto trees = settled({small, small, small});
    for (const TreePlacement& tree : trees)
        EXPECT_FALSE(tree.openGrown);
    EXPECT_TRUE(settled({small}).front().openGrown);
}

TEST(CompanyOfTrees, NeighboursDoNotShareAForm) {
    ForestDescription forest = growing(wood());
    const std::vector<UnsaidOfTree> unsaid(forest.trees.size());
    findCompany(forest, unsaid);
    for (std::size_t i = 0; i < forest.trees.size(); ++i)
        forest.trees[i].seed = static_cast<std::uint32_t>(7 * i * i);
    const auto alike = [&] { // trees that have the same form as one beside them
        const ShapeFamilies families(forest);
        const auto formOf = [&](const TreePlacement& tree) {
            const std::size_t family = families.indexOf(tree);
            return std::make_pair(family, tree.seed % families.all()[family].shapes);
        };
        int count = 0;
        for (const TreePlacement& a : forest.trees)
            for (const TreePlacement& b : forest.trees)
                count += &a != &b && glm::distance(a.position, b.position) < 7.0 && formOf(a) == formOf(b);
        return count;
    };
    EXPECT_GT(alike(), 40);
    tellApart(forest, unsaid);
    EXPECT_EQ(alike(), 0);
    UnsaidOfTree said;
    said.seed = false;
    const std::uint32_t before = forest.trees[60].seed = forest.trees[59].seed;
    tellApart(forest, std::vector<UnsaidOfTree>(forest.trees.size(), said));
    EXPECT_EQ(forest.trees[60].seed, before) << "which the file says";
}

TEST(CompanyOfTrees, TheLargestSeedsAreToldApartToo) {
    ForestDescription forest = growing({treeAt(0, 0), treeAt(5, 0)});
    forest.trees[0].seed = forest.trees[1].seed = std::numeric_limits<std::uint32_t>::max();
    tellApart(forest, std::vector<UnsaidOfTree>(2));
    EXPECT_NE(forest.trees[0].seed % 8, forest.trees[1].seed % 8);
}
