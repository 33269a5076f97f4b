// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeCells.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace osgTreeWind;

namespace {

TreeCells::Tree treeAt(float x, float y, std::uint32_t slot) {
    return {osg::Vec3(x, y, 2.0f), 10.0f, 3.0f, slot};
}

std::set<std::uint32_t> slotsIn(const TreeCells& cells) {
    std::set<std::uint32_t> slots;
    for (const TreeCells::Cell& cell : cells.cells())
        for (const TreeCells::Tree& tree : cell.trees)
            EXPECT_TRUE(slots.insert(tree.slot).second) << tree.slot << " is in two cells";
    return slots;
}

} // namespace

TEST(TreeCellsTest, BoundsContainSwayingTrees) {
    TreeCells cells;
    EXPECT_FALSE(cells.bounds().valid());
    cells.insert(treeAt(-100.0f, 5.0f, 0));
    cells.insert(treeAt(300.0f, -40.0f, 1));
    const osg::BoundingBox bounds = cells.bounds();
    EXPECT_LT(bounds.xMin(), -100.0f - 3.0f);
    EXPECT_GT(bounds.xMax(), 300.0f + 3.0f);
    EXPECT_GE(bounds.zMax(), 12.0f);
    EXPECT_LE(bounds.zMin(), 2.0f);
}

TEST(TreeCellsTest, BoundsShrinkWhenATreeIsRemoved) {
    TreeCells cells;
    cells.insert(treeAt(1.0f, 1.0f, 0));
    const osg::BoundingBox before = cells.bounds();
    cells.insert(treeAt(2000.0f, 1.0f, 1));
    EXPECT_GT(cells.bounds().xMax(), 2000.0f);
    cells.remove(1);
    EXPECT_EQ(cells.bounds()._max, before._max);
    cells.insert(treeAt(40.0f, 1.0f, 2)); // in the same cell as the first
    cells.remove(2);
    EXPECT_EQ(cells.bounds()._max, before._max);
    cells.remove(0);
    EXPECT_FALSE(cells.bounds().valid());
}

TEST(TreeCellsTest, MovedTreeLeavesItsCell) {
    TreeCells cells;
    cells.insert(treeAt(0.0f, 0.0f, 0));
    cells.insert(treeAt(5.0f, 0.0f, 1));
    cells.insert(treeAt(1000.0f, 0.0f, 0));
    EXPECT_EQ(slotsIn(cells).size(), 2u);
    EXPECT_EQ(cells.tree(0).foot.x(), 1000.0f);
    EXPECT_EQ(cells.tree(1).foot.x(), 5.0f);
    EXPECT_LT(cells.bounds().xMin(), 5.0f);
    cells.remove(1);
    EXPECT_GT(cells.bounds().xMin(), 900.0f);
}

TEST(TreeCellsTest, TreesStayInTheirCellsUnderRandomChanges) {
    TreeCells cells;
    std::set<std::uint32_t> expected;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> anywhere(-500.0f, 500.0f);
    for (int i = 0; i < 3000; ++i) {
        const std::uint32_t slot = random() % 200;
        if (random() % 3) {
            cells.insert(treeAt(anywhere(random), anywhere(random), slot));
            expected.insert(slot);
        } else {
            cells.remove(slot);
            expected.erase(slot);
        }
    }
    EXPECT_EQ(slotsIn(cells), expected);
    const osg::BoundingBox all = cells.bounds();
    for (const TreeCells::Cell& cell : cells.cells())
        for (const TreeCells::Tree& tree : cell.trees) {
            EXPECT_TRUE(cell.box.contains(tree.foot));
            EXPECT_TRUE(all.contains(TreeCells::swayBox(tree)._max));
            EXPECT_LT(std::abs(tree.foot.x() - cell.trees[0].foot.x()), TreeCells::side);
            EXPECT_LT(std::abs(tree.foot.y() - cell.trees[0].foot.y()), TreeCells::side);
        }
}

TEST(TreeCellsTest, CellsAreReused) {
    TreeCells cells;
    for (int round = 0; round < 50; ++round)
        for (std::uint32_t slot = 0; slot < 100; ++slot)
            cells.insert(treeAt(10.0f * static_cast<float>(slot), 0.0f, slot));
    EXPECT_LE(cells.cells().size(), 22u);
}
