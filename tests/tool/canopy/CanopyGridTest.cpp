// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/tool/canopy/SmallWood.h>

#include <examples/osgtreewind/canopy/CanopyGrid.h>

#include <cmath>

namespace osgTreeWind {

TEST(CanopyGrid, HoldsAllTreesAndBeginsAtAWholeCell) {
    const PlacedForest forest(smallWood());
    const glm::dvec3 cell(2.0, 3.0, 0.5);
    const CanopyGrid grid = gridOver(forest, cell);
    glm::dvec3 low(1e300), high(-1e300);
    for (const PlacedTree& tree : forest.trees) {
        const TreeBox box = treeBox(forest, tree);
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(std::remainder(grid.low[axis], cell[axis]), 0.0);
        EXPECT_LE(grid.low[axis], low[axis]);
        EXPECT_GE(grid.high()[axis], high[axis]);
        EXPECT_LT(low[axis] - grid.low[axis], cell[axis]) << "no larger than needed";
        EXPECT_LT(grid.high()[axis] - high[axis], cell[axis]);
    }
}

TEST(CanopyGrid, ABoxIsAsWideAndHighAsTheTree) {
    ForestDescription wood = smallWood();
    for (TreePlacement& tree : wood.trees)
        tree.heading = 0.0f;
    const PlacedForest forest(wood);
    for (const PlacedTree& tree : forest.trees) {
        const TreeBox box = treeBox(forest, tree);
        const TreeSize size = forest.sizeOf(tree);
        const glm::dvec3 extent = box.high - box.low;
        EXPECT_NEAR(extent.z, static_cast<double>(size.height), 1e-3 * extent.z);
        EXPECT_NEAR(0.5 * (extent.x + extent.y), static_cast<double>(size.crownWidth), 1e-3 * extent.x);
    }
}

TEST(CanopyGrid, CoversTheGivenBounds) {
    const PlacedForest forest(smallWood());
    const glm::dvec2 corner(forest.description().origin);
    const CanopyGrid grid =
        gridOver(forest, {2.0, 4.0, 1.0}, true, CanopyBounds{corner - 10.0, corner + glm::dvec2(10.0, 30.0)});
    EXPECT_EQ(glm::dvec2(grid.low), corner - 10.0);
    EXPECT_EQ(grid.cells.x, 10);
    EXPECT_EQ(grid.cells.y, 10);
    EXPECT_EQ(grid.low.z, 0.0);
}

TEST(CanopyGrid, HasOneLevelWithoutTrees) {
    const PlacedForest forest(smallWood());
    const CanopyGrid grid = gridOver(forest, {1.0, 1.0, 1.0}, false, CanopyBounds{{0.0, 0.0}, {5.0, 5.0}});
    EXPECT_EQ(grid.cells, glm::ivec3(5, 5, 1));
}

TEST(CanopyGrid, ReportsInvalidBoundsAndCells) {
    const PlacedForest forest(smallWood());
    const CanopyBounds tenAndAHalf{{0.0, 0.0}, {10.5, 10.0}}, empty{{0.0, 0.0}, {0.0, 10.0}},
        reversed{{10.0, 0.0}, {0.0, 10.0}};
    const glm::dvec3 metre(1.0);
    for (const auto& bounds : {tenAndAHalf, empty, reversed})
        EXPECT_NE(
            firstProblem(canopyGridOver(forest, metre, true, bounds)).find("bounds: expected a whole number"),
            std::string::npos);
    EXPECT_NE(
        firstProblem(canopyGridOver(forest, metre, true, tenAndAHalf)).find("between 0 and 10.5, found 10.5"),
        std::string::npos);
    EXPECT_NE(firstProblem(canopyGridOver(forest, glm::dvec3(1e-3), true)).find("cell: expected a size"),
              std::string::npos);
    EXPECT_NE(firstProblem(canopyGridOver(forest, glm::dvec3(1e-300), true)).find("cell: expected a size"),
              std::string::npos);
    ForestDescription bare = smallWood();
    bare.trees.clear();
    EXPECT_NE(firstProblem(canopyGridOver(PlacedForest(bare), metre, true)).find("bounds: expected x0"),
              std::string::npos);
}

} // namespace osgTreeWind
