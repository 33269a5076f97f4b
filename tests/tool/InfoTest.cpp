// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/TestData.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/tool/Tool.h>

#include <nlohmann/json.hpp>

namespace {

nlohmann::json infoOf(const std::string& file) {
    const Outcome outcome = runTool({"info", file, "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json info = nlohmann::json::parse(outcome.out, nullptr, false);
    EXPECT_FALSE(info.is_discarded()) << outcome.out;
    return info;
}

} // namespace

TEST(Info, ReferenceTreeHasTheCountsOfTheThesis) {
    const nlohmann::json info = infoOf(example("thesis.treewind"));
    const std::pair<const char*, int> expected[] = {{"trees", 1},
                                                    {"units", 122},
                                                    {"branches", 120},
                                                    {"skeletonPoints", 1952},
                                                    {"skinVertices", 15616},
                                                    {"skinTriangles", 29280},
                                                    {"leafVertices", 23040},
                                                    {"leafTriangles", 11520},
                                                    {"totalVertices", 38656},
                                                    {"totalTriangles", 40800}};
    for (const auto& [key, count] : expected) {
        EXPECT_EQ(info[key], count) << key;
        EXPECT_EQ(info["species"][0][key], count) << key;
    }
    EXPECT_EQ(info["motion"]["law"], "thesis");
    EXPECT_NEAR(info["wind"]["velocityAtOrigin10m"][0], 4.0, 1e-6);
}

TEST(Info, TotalsAreTheSumsOfTheSpecies) {
    const nlohmann::json info = infoOf(example("forest.treewind"));
    EXPECT_EQ(info["trees"], 40);
    EXPECT_EQ(info["species"].size(), 3u);
    for (const char* key : {"trees", "units", "totalVertices", "totalTriangles"}) {
        int sum = 0;
        for (const nlohmann::json& species : info["species"])
            sum += species[key].get<int>();
        EXPECT_EQ(info[key].get<int>(), sum) << key;
    }
}

TEST(Info, BoundsHoldTheTreesAtTheirSizes) {
    const TemporaryFolder folder;
    const nlohmann::json info = infoOf(folder.write("two.treewind", R"(version = 1
[[tree]]
position = [100.0, 20.0, 3.0]
height = 10.0
crown_width = 6.0
[[tree]]
position = [110.0, 40.0, 0.0]
height = 8.0
crown_width = 4.0
)"));
    const double low[] = {97.0, 17.0, 0.0}, high[] = {112.0, 42.0, 13.0};
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(info["bounds"]["low"][axis], low[axis], 1e-5) << axis;
        EXPECT_NEAR(info["bounds"]["high"][axis], high[axis], 1e-5) << axis;
    }
}

TEST(Info, ATreeWithoutSizesHasTheHeightOfItsShape) {
    const nlohmann::json bounds = infoOf(example("thesis.treewind"))["bounds"];
    EXPECT_GT(bounds["high"][2], 4.0); // two trunk units of 1.2 m and four levels of branches
    EXPECT_LT(bounds["high"][2], 9.0);
    EXPECT_GT(bounds["high"][0], 1.0);
    EXPECT_LT(bounds["low"][0], -1.0);
}

TEST(Info, TableShowsTheSameNumbers) {
    const Outcome outcome = runTool({"info", example("thesis.treewind")});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* number : {"122", "29280", "11520", "38656", "40800"})
        EXPECT_NE(outcome.out.find(number), std::string::npos) << number;
}

TEST(Info, CampusHasEveryMeasuredTree) {
    REQUIRE_REAL_DATA(inventory, "utah_campus/utah_campus_trees.csv");
    std::ifstream rows(inventory);
    int trees = -1; // the header
    for (std::string row; std::getline(rows, row);)
        ++trees;
    EXPECT_EQ(trees, 1233);
    EXPECT_EQ(infoOf(example("campus.treewind"))["trees"], trees);
}

TEST(Info, SaysWhatWasTakenOfScansAndWhatWasPruned) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.treewind", "version = 1\nsearch = [\"" OSGTREEWIND_TEST_DATA
                                                        "/scan\"]\n[[species]]\nname = \"sapling\"\n"
                                                        "scan = [\"raycloud.txt\", \"sapling.swc\"]\n"
                                                        "[[tree]]\nposition = [0, 0]\n");
    const nlohmann::json info = infoOf(file);
    const nlohmann::json& species = info["species"][0];
    EXPECT_EQ(species["shapes"], 3);
    ASSERT_EQ(species["scans"].size(), 3u);
    EXPECT_EQ(species["scans"][0]["source"], "raycloud.txt, tree 1");
    EXPECT_EQ(species["scans"][2]["source"], "sapling.swc");
    for (const nlohmann::json& scan : species["scans"]) {
        EXPECT_EQ(scan["cylinders"], 8);
        EXPECT_EQ(scan["taken"], 8);
        EXPECT_EQ(scan["pruned"], 0);
        EXPECT_EQ(scan["units"], species["units"]);
        EXPECT_NEAR(scan["height"], 2.0, 1e-5);
        EXPECT_NEAR(scan["woodVolume"].get<double>() / scan["cylinderVolume"].get<double>(), 1.0, 0.05);
    }
    const Outcome table = runTool({"info", file});
    EXPECT_NE(table.out.find("scan    sapling: sapling.swc, 8 cylinders, 0 pruned; "), std::string::npos)
        << table.out;
}
