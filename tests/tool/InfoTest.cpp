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
    EXPECT_EQ(info["wind"]["intensity"], 0.0);
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

TEST(Info, CountsUsedAndPrunedCylindersOfScans) {
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

TEST(Info, PrintsTheMapAndWhetherItWasChosen) {
    const TemporaryFolder folder;
    folder.write("a.csv", "longitude,latitude\n9.0,0.0\n");
    const std::string inventory =
        "[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"longitude\", y = \"latitude\" }\n";
    const std::string chosen = folder.write("a.treewind", "version = 1\n" + inventory);
    const std::string given = folder.write("b.treewind", "version = 1\ncrs = \"EPSG:25832\"\n" + inventory);
    EXPECT_EQ(infoOf(chosen)["crs"],
              nlohmann::json({{"text", "EPSG:32632"}, {"name", "WGS 84 / UTM zone 32N"}, {"chosen", true}}));
    EXPECT_EQ(infoOf(given)["crs"],
              nlohmann::json({{"text", "EPSG:25832"}, {"name", "ETRS89 / UTM zone 32N"}, {"chosen", false}}));
    EXPECT_TRUE(infoOf(example("thesis.treewind"))["crs"].is_null());
    const auto line = [](const std::string& file) {
        const std::string out = runTool({"info", file}).out;
        const std::size_t at = out.find("crs     ");
        return out.substr(at, out.find('\n', at) - at);
    };
    EXPECT_EQ(line(chosen), "crs     WGS 84 / UTM zone 32N (EPSG:32632), chosen by its data");
    EXPECT_EQ(line(given), "crs     ETRS89 / UTM zone 32N (EPSG:25832)");
    EXPECT_EQ(line(example("thesis.treewind")), "crs     none: metres");
}

TEST(Info, ListsEveryTreeWithItsSizes) {
    const TemporaryFolder folder;
    folder.write("f.treewind", R"(version = 1
[[tree]]
id = "the \"old\" one, by the gate"
species = "oak"
position = [428759.1900000001, 4512931.77, 0.1]
height = 12.3
trunk_diameter = 0.4
[[tree]]
species = "Scots pine"
position = [428760, 4512931, 0]
crown_width = 5.5
[[tree]]
species = "oak"
position = [428770, 4512931, 0]
)");
    const Outcome outcome = runTool({"info", "f.treewind", "--trees", "trees.csv"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    std::istringstream lines(contentOf(folder.path() + "/trees.csv"));
    std::string header, first, second, third, none;
    std::getline(lines, header), std::getline(lines, first), std::getline(lines, second),
        std::getline(lines, third);
    EXPECT_EQ(header, "id,species,x,y,z,height,trunk_diameter,crown_width,open,leaves,given");
    EXPECT_EQ(
        first.find("\"the \"\"old\"\" one, by the gate\",oak,428759.1900000001,4512931.77,0.1,12.3,0.4,"), 0u)
        << first;
    EXPECT_NE(first.find(",height+trunk_diameter"), std::string::npos) << first;
    EXPECT_EQ(second.find(",Scots pine,428760,4512931,0,"), 0u) << second;
    EXPECT_NE(second.find(",5.5,0,1,crown_width"), std::string::npos) << second;
    EXPECT_NE(third.find(",none"), std::string::npos) << third;
    EXPECT_FALSE(std::getline(lines, none));
    double x = 0, y = 0, z = 0, height = 0, trunk = 0, crown = 0;
    ASSERT_EQ(std::sscanf(third.c_str(), ",oak,%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &height, &trunk, &crown),
              6);
    EXPECT_GT(height, 5.0);
    EXPECT_GT(trunk, 0.1);
    EXPECT_GT(crown, 2.0);
    EXPECT_EQ(runTool({"info", "f.treewind", "--trees", "no/trees.csv"}, folder.path()).exitCode, 1);
}

TEST(Info, EstimatedSizesAreNotCalledGiven) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,d\na,1,2,0.3\nb,3,4,\n");
    folder.write("f.treewind", "version = 1\n[inventory]\nfile = \"a.csv\"\ndefault_species = \"oak\"\n"
                               "columns = { id = \"nr\", x = \"x\", y = \"y\", trunk_diameter = \"d\" }\n");
    const Outcome outcome = runTool({"info", "f.treewind", "--trees", "trees.csv"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    std::istringstream lines(contentOf(folder.path() + "/trees.csv"));
    std::string header, first, second;
    std::getline(lines, header), std::getline(lines, first), std::getline(lines, second);
    EXPECT_EQ(first.find("a,oak,1,2,0,"), 0u) << first;
    EXPECT_NE(first.find(",trunk_diameter"), std::string::npos) << first;
    EXPECT_EQ(first.find("height+"), std::string::npos) << first;
    EXPECT_EQ(first.find("+crown_width"), std::string::npos) << first;
    EXPECT_EQ(second.substr(second.rfind(',')), ",none") << second;
}

/// The list works as an inventory of the same forest.
TEST(Info, TreesListedAreReadBack) {
    const TemporaryFolder folder;
    ASSERT_EQ(runTool({"info", example("forest.treewind"), "--trees", "a.csv"}, folder.path()).exitCode, 0);
    folder.write("a.treewind",
                 "version = 1\n[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", z = "
                 "\"z\", species = \"species\", height = \"height\", trunk_diameter = "
                 "\"trunk_diameter\", crown_width = \"crown_width\" }\ndefault_species = \"oak\"\n");
    ASSERT_EQ(runTool({"info", "a.treewind", "--trees", "b.csv"}, folder.path()).exitCode, 0);
    std::istringstream a(contentOf(folder.path() + "/a.csv")), b(contentOf(folder.path() + "/b.csv"));
    std::string before, after;
    // Without id and species, whose text may differ, and without `open`, which follows from the crowns.
    const auto numbers = [](const std::string& row) {
        const std::size_t from = row.find(',', row.find(',') + 1);
        const std::string cells = row.substr(from, row.rfind(',') - from);
        const std::size_t leaves = cells.rfind(','), open = cells.rfind(',', leaves - 1);
        return cells.substr(0, open) + cells.substr(leaves);
    };
    int rows = -1;
    for (; std::getline(a, before) && std::getline(b, after); ++rows)
        if (rows >= 0) {
            EXPECT_EQ(numbers(before), numbers(after));
            EXPECT_NE(after.find(",height+trunk_diameter+crown_width"), std::string::npos);
        }
    EXPECT_EQ(rows, 40);
}
