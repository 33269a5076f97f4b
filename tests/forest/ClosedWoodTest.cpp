// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ClosedWood.h>

#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

using Trees = std::vector<TreePlacement>;

TreePlacement treeAt(double x, double y, float height, float crownWidth) {
    TreePlacement tree;
    tree.position = {x, y, 0.0};
    tree.size.height = height;
    tree.size.crownWidth = crownWidth;
    return tree;
}

/// Trees of 15 m on a square grid.
Trees rowsOf(int side, double spacing, float crownWidth, double x = 0.0) {
    Trees trees;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            trees.push_back(treeAt(x + spacing * column, spacing * row, 15.0f, crownWidth));
    return trees;
}

Trees together(Trees a, const Trees& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

double closedShare(const Trees& trees) {
    return shareInClosedWood({Species()}, trees.size(), [&](const TreeVisitor& visitor) {
        visitor({trees.begin(), trees.begin() + static_cast<std::ptrdiff_t>(trees.size() / 2)});
        visitor({trees.begin() + static_cast<std::ptrdiff_t>(trees.size() / 2), trees.end()});
    });
}

} // namespace

/// Circles in a square grid, wider than those that touch, cover c = w²/s² · π/4 of the ground.
TEST(ClosedWoodTest, CrownsCoverHalfOfTheGround) {
    const double half = std::sqrt(0.5 * 4.0 / glm::pi<double>()); // width over spacing
    for (const double spacing : {3.0, 5.0, 8.0}) {
        const int side = static_cast<int>(400.0 / spacing);
        EXPECT_GT(closedShare(rowsOf(side, spacing, static_cast<float>(1.1 * half * spacing))), 0.6)
            << spacing;
        EXPECT_EQ(closedShare(rowsOf(side, spacing, static_cast<float>(0.9 * half * spacing))), 0.0)
            << spacing;
    }
}

/// Overlapping crowns count once: ten trees at each place of an open grid do not close it.
TEST(ClosedWoodTest, OverlapCountsOnce) {
    Trees trees;
    for (int i = 0; i < 10; ++i)
        trees = together(std::move(trees), rowsOf(30, 12.0, 8.0f));
    EXPECT_EQ(closedShare(trees), 0.0);
}

TEST(ClosedWoodTest, CountsTreesNotGround) {
    const Trees wood = rowsOf(60, 4.0, 6.0f), scattered = rowsOf(60, 40.0, 6.0f, 1000.0);
    EXPECT_NEAR(closedShare(together(wood, scattered)), 0.5 * closedShare(wood), 0.02);
}

/// In a belt of two rows, and in a clump smaller than two heights, most of the ground around is open.
TEST(ClosedWoodTest, BeltsAndClumpsAreOpen) {
    Trees belt;
    for (int i = 0; i < 400; ++i)
        belt.push_back(treeAt(4.0 * (i / 2), 4.0 * (i % 2), 15.0f, 5.0f));
    EXPECT_EQ(closedShare(belt), 0.0);
    EXPECT_EQ(closedShare(rowsOf(5, 4.0, 5.0f)), 0.0);
    EXPECT_EQ(closedShare(rowsOf(1, 4.0, 5.0f)), 0.0);
    EXPECT_EQ(closedShare({}), 0.0);
}

} // namespace osgTreeWind
