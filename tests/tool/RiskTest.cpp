// SPDX-License-Identifier: MIT
#include <tests/tool/Pictures.h>
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace {

const std::string three = R"(version = 1
[[species]]
name = "spruce"
like = "Sitka spruce"
[[tree]]
position = [0, 0]
[[tree]]
position = [300, 0]
[[tree]]
position = [600, 0]
)";

std::vector<std::vector<std::string>> cellsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        std::istringstream cells(line + ',');
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(cell);
    }
    return rows;
}

TEST(Risk, WritesCriticalWindsAndRatios) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/risk.csv";
    const Outcome outcome =
        runTool({"risk", folder.write("three.treewind", three), "-o", path, "--speed", "20"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto rows = cellsOf(contentOf(path));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"id", "species", "x", "y", "height_m", "dbh_cm",
                                                 "crown_width_m", "uproot_ms", "break_ms", "bough_ms",
                                                 "top_wind", "uproot_ratio", "break_ratio", "bough_ratio"}));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), 14u);
        for (const std::size_t kind :
             {0, 1, 2}) { // the ratio is above 1 if the critical wind is below that of the storm
            const double ratio = std::atof(rows[i][11 + kind].c_str());
            const bool isBeyond = rows[i][7 + kind].empty();
            const double critical = isBeyond ? 80.0 : std::atof(rows[i][7 + kind].c_str());
            EXPECT_FALSE(isBeyond && kind < 2);
            EXPECT_GT(critical, 2.0);
            EXPECT_GT(ratio, 0.0);
            EXPECT_EQ(ratio > 1.0, critical < 20.0) << ratio << ' ' << critical;
        }
    }
    EXPECT_EQ(rows[2][2], "300.000");
}

/// Three trees from west to east, on white, in the middle of the picture.
TEST(Risk, DrawsTheForestFromAbove) {
    const TemporaryFolder folder;
    const std::string file = folder.write("three.treewind", three);
    for (const std::string name : {"map.png", "map.svg"}) {
        const Outcome outcome = runTool(
            {"risk", file, "-o", folder.path() + "/risk.csv", "--picture", folder.path() + '/' + name});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    const osg::ref_ptr<osg::Image> map = pictureIn(folder, "map.png");
    ASSERT_EQ(map->s(), 1000);
    ASSERT_EQ(map->t(), 800);
    std::vector<int> trees; // centres of the runs of coloured pixels in the row of the trees
    int first = -1;
    for (int x = 0; x < 840; ++x) {
        const osg::Vec4 colour = map->getColor(static_cast<unsigned>(x), 395);
        const bool isTree = colour.r() < 0.95f || colour.g() < 0.95f || colour.b() < 0.95f;
        if (isTree && first < 0)
            first = x;
        if (!isTree && first >= 0) {
            trees.push_back((first + x) / 2);
            first = -1;
        }
    }
    ASSERT_EQ(trees.size(), 3u);
    EXPECT_NEAR(trees[1] - trees[0], trees[2] - trees[1], 2);
    EXPECT_GT(trees[2] - trees[0], 700);
    const std::string svg = contentOf(folder.path() + "/map.svg");
    EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST(Risk, RefusesInvalidOutputsAndOptions) {
    const TemporaryFolder folder;
    const std::string file = folder.write("three.treewind", three);
    const Outcome text = runTool({"risk", file, "-o", "risk.txt"});
    EXPECT_EQ(text.exitCode, 2);
    EXPECT_NE(text.err.find("--output: expected a name that ends in .csv or .gpkg, found risk.txt"),
              std::string::npos)
        << text.err;
    EXPECT_EQ(runTool({"risk", file, "-o", "risk.csv", "--speed", "-3"}).exitCode, 2);
    const Outcome picture = runTool({"risk", file, "-o", "risk.csv", "--picture", "risk.jpg"});
    EXPECT_EQ(picture.exitCode, 2);
    EXPECT_NE(picture.err.find("--picture: expected a name that ends in .svg or .png, found risk.jpg"),
              std::string::npos)
        << picture.err;
    const Outcome nowhere = runTool({"risk", file, "-o", "/nowhere/risk.gpkg"});
    EXPECT_EQ(nowhere.exitCode, 1);
    EXPECT_EQ(nowhere.err, "/nowhere/risk.gpkg: cannot be written: there is no folder /nowhere\n");
    EXPECT_EQ(runTool({"risk", "/nowhere.treewind", "-o", "risk.csv"}).exitCode, 2);
}

} // namespace
