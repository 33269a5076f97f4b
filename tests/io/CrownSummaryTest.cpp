// SPDX-License-Identifier: MIT
// The summary of the crowns of a tiled forest.
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

using namespace osgTreeWind;

namespace {

ForestDescription scattered() {
    std::istringstream text("version = 1\n[wind]\nkind = \"calm\"\n"
                            "[[scatter]]\ncount = 600\narea = [-500.0, 200.0, 900.0, 1300.0]\n"
                            "species = [\"oak\", \"Norway spruce\"]\nheight = [4.0, 30.0]\n");
    return readForest(text).value();
}

} // namespace

TEST(CrownSummaryTest, cellsSumTheirTrees) {
    const TemporaryFolder folder;
    ForestDescription forest = scattered();
    TilingOptions options;
    options.size = 500.0; // 4 x 4 cells of 125 m
    const auto tiles = writeTiledForest(forest, folder.path(), options);
    ASSERT_TRUE(tiles) << tiles.problems().front().text();
    std::ifstream input(folder.path() + "/tiles/all.crowns");
    const Result<CrownSummary> summary = readCrownSummary(input, "all.crowns");
    ASSERT_TRUE(summary) << summary.problems().front().text();

    std::map<std::pair<int, int>, std::array<double, 3>> expected; // count, heights, squares of widths
    const PlacedForest placed(forest);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        const glm::dvec2 place = (glm::dvec2(forest.trees[i].position) - tiles.value().corner) / 125.0;
        const TreeSize size = placed.sizeOf(placed.trees[i]);
        auto& [count, height, square] = expected[{static_cast<int>(place.x), static_cast<int>(place.y)}];
        count += 1.0;
        height += static_cast<double>(size.height);
        square += static_cast<double>(size.crownWidth * size.crownWidth);
    }
    ASSERT_EQ(summary.value().cells.size(), expected.size());
    for (const CrownCell& cell : summary.value().cells) {
        const auto found = expected.find({static_cast<int>(cell.column), static_cast<int>(cell.row)});
        ASSERT_NE(found, expected.end()) << cell.column << ' ' << cell.row;
        const auto& [count, height, square] = found->second;
        EXPECT_EQ(cell.trees, count);
        EXPECT_NEAR(static_cast<double>(cell.height), height / count, 0.051);
        EXPECT_NEAR(static_cast<double>(cell.width), std::sqrt(square / count), 0.051);
    }
}

TEST(CrownSummaryTest, problemsHaveALine) {
    const std::string head = "column,row,trees,foot,height,width,species\n";
    const auto problemOf = [](const std::string& text) {
        std::istringstream input(text);
        const Result<CrownSummary> summary = readCrownSummary(input, "all.crowns");
        return summary ? std::string() : summary.problems().front().text();
    };
    EXPECT_EQ(problemOf(head + "0,1,20,510.5,14,6.1,oak\n"), "");
    EXPECT_EQ(problemOf(head), "") << "a file without cells is valid";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"0,1", "all.crowns:2:"},
        {"0,1,20,510.5,14,6.1,oak\n-1,1,20,510.5,14,6.1,oak", "all.crowns:3: column: expected a number"},
        {"0,1,0,510.5,14,6.1,oak", "all.crowns:2: trees: expected a number"},
        {"0,1,20,nan,14,6.1,oak", "all.crowns:2: foot: expected a number"},
        {"0,1,20,510.5,0,6.1,oak", "all.crowns:2: height: expected a number"},
        {"0,1,20,510.5,14,900,oak", "all.crowns:2: width: expected a number"},
    };
    for (const auto& [rows, expected] : cases)
        EXPECT_EQ(problemOf(head + rows + '\n').substr(0, expected.size()), expected) << rows;
    EXPECT_TRUE(hasPart(problemOf("x,y\n1,2\n"), "expected the columns column, row"));
    EXPECT_NE(problemOf(""), "");
}
