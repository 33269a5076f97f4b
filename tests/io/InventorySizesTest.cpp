// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/species/SizeLaws.h>

#include <map>

namespace osgTreeWind {

namespace {

const char* const sizeColumns =
    "columns = { id = \"nr\", x = \"x\", y = \"y\", height = \"h\", trunk_diameter = \"d\" }\n";

std::map<std::string, TreeSize> sizesOf(const ForestDescription& forest) {
    std::map<std::string, TreeSize> sizes;
    for (const TreePlacement& tree : forest.trees)
        sizes[tree.name] = tree.size;
    return sizes;
}

void expectSame(const std::map<std::string, TreeSize>& a, const std::map<std::string, TreeSize>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, size] : a) {
        EXPECT_EQ(size.height, b.at(name).height) << name;
        EXPECT_EQ(size.trunkDiameter, b.at(name).trunkDiameter) << name;
        EXPECT_EQ(size.crownWidth, b.at(name).crownWidth) << name;
    }
}

} // namespace

TEST(InventorySizes, EstimatesDoNotDependOnOrderFileOrSeed) {
    const TemporaryFolder folder;
    const std::string head = "nr,x,y,h,d\n", a = "a,1,2,,0.3\n", b = "b,3,4,9,\n", c = "c,5,6,,\n";
    folder.write("one.csv", head + a + b + c);
    folder.write("two.csv", head + c + b + "d,7,8,,0.4\n" + a);
    const auto one = sizesOf(inventoryOf(folder.path(), "file = \"one.csv\"\n" + std::string(sizeColumns)));
    auto two = sizesOf(
        inventoryOf(folder.path(), "file = \"two.csv\"\nseed = 9\n" + std::string(sizeColumns), "seed = 7"));
    EXPECT_NE(two["d"].height, 0.0f);
    two.erase("d");
    expectSame(one, two);
    expectSame(one, sizesOf(inventoryOf(folder.path(), "file = \"one.csv\"\n" + std::string(sizeColumns))));
}

TEST(InventorySizes, EstimatesDependOnTheIdOrRowNumber) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\n,1,2,,0.3\n5,1,3,,0.3\n5,1,4,,0.3\n,1,5,,0.3\n2,1,6,,0.3\n");
    const auto trees = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)).trees;
    ASSERT_EQ(trees.size(), 5u);
    const float law = 31.8f * std::pow(0.3f, 0.441f); // beeches in a stand
    EXPECT_NEAR(std::log(trees[0].size.height / law), 0.186 * residual("1", "height"), 1e-5);
    EXPECT_NEAR(std::log(trees[3].size.height / law), 0.186 * residual("4", "height"), 1e-5);
    EXPECT_NEAR(std::log(trees[4].size.height / law), 0.186 * residual("2", "height"), 1e-5);
    EXPECT_EQ(trees[1].size.height, trees[2].size.height) << "they have the same id";
    EXPECT_TRUE(trees[2].name.empty());
}

TEST(InventorySizes, EstimatesDependOnTheGrowingSpace) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\n");
    const std::string lines = "file = \"a.csv\"\n" + std::string(sizeColumns);
    const TreeSize forest = inventoryOf(folder.path(), lines).trees[0].size;
    const TreeSize open = inventoryOf(folder.path(), lines + "open_grown = true\n").trees[0].size;
    EXPECT_GT(forest.height, open.height);
    EXPECT_LT(forest.crownWidth, open.crownWidth);
}

TEST(InventorySizes, EstimatesAreNoted) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,\nc,1,3,,\nd,1,3,9,0.3\n");
    const auto notes = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)).notes;
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_TRUE(hasPart(notes[0],
                        "a.csv: estimated by the laws of the species: height of 2, trunk diameter of 1, "
                        "crown width of 3 trees"));
    // exp(r), 1/r^2 = 1/0.62^2 + 0.441^2/0.186^2
    EXPECT_TRUE(hasPart(notes[1],
                        "a.csv: two of three estimated trunk diameters are right within a factor of "
                        "1.42"))
        << notes[1];
}

TEST(InventorySizes, EstimatesAreWrittenAsSuch) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,0.3\n");
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns));
    std::stringstream text;
    ASSERT_TRUE(writeForest(forest, text).empty());
    const auto again = readForest(text);
    ASSERT_TRUE(again.ok()) << again.problems().front().text();
    expectSame(sizesOf(forest), sizesOf(again.value()));
    const auto& trees = again.value().trees;
    EXPECT_TRUE(trees[0].estimated.height && !trees[0].estimated.trunkDiameter);
    EXPECT_FALSE(trees[1].estimated.height);
    EXPECT_TRUE(trees[1].estimated.crownWidth);
}

TEST(InventorySizes, EstimatesAreKeptByPlacedForest) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,0.3\n");
    PlacedForest placed(inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)));
    const TreePlacement turned = [&] {
        TreePlacement tree = placed.placementOf(0);
        tree.heading = 1.0f;
        return tree;
    }();
    placed.put(0, placed.makePlacedTree(turned, &placed.trees[0]), turned.name);
    const auto trees = placed.currentDescription().trees;
    EXPECT_TRUE(trees[0].estimated.height && !trees[0].estimated.trunkDiameter);
    EXPECT_EQ(trees[0].heading, 1.0f);
    EXPECT_FALSE(trees[1].estimated.height);
}

TEST(InventorySizes, FollowTheShapeWithoutLaws) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\n");
    const TreePlacement tree = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns),
                                           "[[species]]\nname = \"beech\"\n")
                                   .trees[0];
    EXPECT_EQ(tree.size.height, 0.0f);
    EXPECT_FALSE(tree.estimated.height);
}

TEST(InventorySizes, SizesFarAboveTheRecordOfASpeciesAreUnknown) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,s\na,1,2,60,Tilia cordata\nb,1,3,75,Tilia cordata\nc,1,9,75,Sequoia\n");
    const ForestFile forest =
        inventoryOf(folder.path(),
                    "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\", "
                    "species = \"s\" }\n",
                    "");
    ASSERT_EQ(forest.trees.size(), 3u);
    EXPECT_EQ(forest.trees[0].size.height, 60.0f);
    EXPECT_NE(forest.trees[1].size.height, 75.0f);
    EXPECT_LE(forest.trees[1].size.height, 46.5f);
    EXPECT_EQ(forest.trees[2].size.height, 75.0f) << "conifers have no common record";
    EXPECT_TRUE(
        hasPart(forest.notes[0], "impossible sizes count as not measured: height of 1 rows, the first: "));
    EXPECT_TRUE(hasPart(forest.notes[0],
                        "h: expected at most 69.75 metres, 1.5 times species.height.largest, "
                        "found \"75\""));
}

TEST(InventorySizes, InvalidLawsAreOneErrorWithTheirKey) {
    for (const auto& [line, expected] : {std::pair("scale = -1.0", "species.height.scale"),
                                         {"power = 0.0", "species.height.power"},
                                         {"spread = 2.5", "species.height.spread"},
                                         {"open_scale = nan", "species.height.open_scale"},
                                         {"open_power = \"a\"", "species.height.open_power"},
                                         {"sprad = 0.1", "species.height.sprad"}}) {
        std::istringstream input("version = 1\n[[species]]\nname = \"a\"\n[species.height]\n" +
                                 std::string(line) + "\n[[tree]]\nposition = [0, 0]\n");
        const auto forest = readForest(input, {"test.treewind", ""});
        ASSERT_EQ(forest.problems().size(), 1u) << line;
        const std::string problem = forest.problems()[0].text();
        EXPECT_TRUE(hasPart(problem, "test.treewind:5:"));
        EXPECT_TRUE(hasPart(problem, expected));
    }
}

TEST(InventorySizes, EmptySpeciesArrayIsAnError) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,s\n1,2,moon tree\n");
    std::istringstream input("version = 1\nspecies = []\n[inventory]\nfile = \"a.csv\"\n"
                             "columns = { x = \"x\", y = \"y\", species = \"s\" }\n");
    EXPECT_FALSE(readForest(input, {"test.treewind", folder.path()}).ok());
}

TEST(InventorySizes, ImpossibleSizesCountAsNotGiven) {
    const TemporaryFolder folder;
    folder.write("a.csv",
                 "x,y,h,d\n1,1,9,30\n2,2,327,0\n3,3,0,-99\n4,4,-9999,25\n5,5,tall,999\n6,6,8,77\n7,7,7,40\n");
    const std::string lines =
        "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\", trunk_diameter = "
        "\"d\" }\nunits = { trunk_diameter = \"cm\" }\n";
    const ForestFile forest = inventoryOf(folder.path(), lines + "missing = [77]\n");
    ASSERT_EQ(forest.trees.size(), 7u) << "impossible sizes do not remove trees";
    EXPECT_TRUE(forest.trees[1].estimated.height);
    EXPECT_TRUE(forest.trees[5].estimated.trunkDiameter);
    EXPECT_FALSE(inventoryOf(folder.path(), lines).trees[5].estimated.trunkDiameter);
    const std::string notes = notesOf(forest);
    EXPECT_TRUE(hasPart(
        notes, "0 and markers such as -99 count as not measured: height of 2, trunk diameter of 4 rows"));
    EXPECT_TRUE(
        hasPart(notes, "sizes that cannot be read count as not measured: height of 1 rows, the first: "));
    EXPECT_TRUE(hasPart(notes, "a.csv:6: h: expected a size, such as 18, 18 m, 9-12 or >18, found 'tall'"));
    EXPECT_TRUE(hasPart(notes, "impossible sizes count as not measured: height of 1 rows, the first: "));
    EXPECT_TRUE(hasPart(notes, "a.csv:3: h: expected in (0, 116] metres, found \"327\""));
}

TEST(InventorySizes, MostlyImpossibleSizesAreAProblem) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n1,1,900\n2,2,1200\n3,3,1500\n4,4,20\n");
    const auto forest = readInventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\n");
    ASSERT_FALSE(forest);
    const std::string problem = forest.problems().front().text();
    EXPECT_TRUE(hasPart(problem, "a.csv:2: h: "));
    EXPECT_TRUE(
        hasPart(problem, "the same applies to 3 of 4 rows: set their unit with inventory.units.height"));
}

namespace {

const std::string wordColumns =
    "columns = { height = \"h\", trunk_diameter = \"d\" }\nunits = { trunk_diameter = \"cm\" }\n";

/// GeoJSON with a tree for each height and diameter, as texts.
std::string treesAsTexts(const std::vector<std::pair<std::string, std::string>>& sizes) {
    std::string features;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        features += (i == 0 ? "" : ",") +
                    (R"({"type": "Feature", "properties": {"h": ")" + sizes[i].first + R"(", "d": ")" +
                     sizes[i].second + R"("}, "geometry": {"type": "Point", "coordinates": [9.)") +
                    std::to_string(9800 + i) + R"(, 53.55]}})";
    return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

} // namespace

TEST(InventorySizes, ReadsWords) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x;y;h;d;w\n1;1;9-12;12+14+9;8 x 6\n2;2;>18 m;\"20; 15\";7\n3;3;60 ft;3x10;\n"
                          "4;4;16;45 cm;9 m\n5;5;~17;0,3 m;\n6;6;0 m;12,5;\n");
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\", "
                                   "trunk_diameter = \"d\", crown_width = \"w\" }\n"
                                   "units = { trunk_diameter = \"cm\" }\n");
    ASSERT_EQ(forest.trees.size(), 6u);
    const double heights[] = {10.5, 18.0, 60 * 0.3048, 16.0, 17.0}, // by hand
        diameters[] = {std::sqrt(421.0) / 100, 0.25, std::sqrt(300.0) / 100, 0.45, 0.3, 0.125};
    for (std::size_t i = 0; i < 6; ++i) {
        const TreePlacement& tree = forest.trees[i];
        if (i < 5) {
            EXPECT_NEAR(tree.size.height, heights[i], 1e-5) << i;
        }
        EXPECT_NEAR(tree.size.trunkDiameter, diameters[i], 1e-6) << i;
        EXPECT_EQ(tree.estimated.height, i == 0 || i == 1 || i == 4 || i == 5) << i;
        EXPECT_FALSE(tree.estimated.trunkDiameter) << i;
    }
    EXPECT_EQ(forest.trees[0].size.crownWidth, 7.0f);
    const std::string notes = notesOf(forest);
    for (const char* const note :
         {"0 and markers such as -99 count as not measured: height of 1 rows",
          "sizes in words are read: crown width of 2, height of 4, trunk diameter of 5 rows, the first: ",
          "a.csv:2: w: \"8 x 6\" as 7 m",
          "classes, bounds and approximate sizes count as estimates: height of 3 rows",
          "units in cells count rather than inventory.units: trunk diameter of 2 rows"})
        EXPECT_TRUE(hasPart(notes, note)) << notes;
}

/// "20,15" is a decimal number or two stems.
TEST(InventorySizes, SaysHowItReadsCommas) {
    const TemporaryFolder folder;
    const std::string lines = "file = \"a.geojson\"\n" + wordColumns, dot = "decimal = \".\"\n";
    folder.write("a.geojson", treesAsTexts({{"18,5", "20,15"}, {"16,5", "30"}}));
    const ForestFile forest = inventoryOf(folder.path(), lines);
    EXPECT_EQ(forest.trees.at(0).size.height, 18.5f);
    EXPECT_FALSE(forest.trees.at(0).estimated.height);
    EXPECT_FLOAT_EQ(forest.trees.at(0).size.trunkDiameter, 0.2015f);
    EXPECT_TRUE(hasPart(notesOf(forest),
                        "commas are read as decimal (decimal = \".\" reads several stems): trunk "
                        "diameter of 1 rows"));
    EXPECT_FLOAT_EQ(inventoryOf(folder.path(), dot + lines).trees.at(0).size.trunkDiameter, 0.25f);
    const ForestFile stated = inventoryOf(folder.path(), "decimal = \",\"\n" + lines);
    EXPECT_FLOAT_EQ(stated.trees.at(0).size.trunkDiameter, 0.2015f);
    EXPECT_FALSE(hasPart(notesOf(stated), "commas"));
    folder.write("a.geojson", treesAsTexts({{"18", "20,15"}, {"16", "12, 14, 9"}}));
    EXPECT_TRUE(hasPart(readInventoryOf(folder.path(), lines).problems().at(0).text(),
                        "d: feature 0: expected either a decimal comma or two stems, found '20,15': set "
                        "inventory.decimal"));
    EXPECT_FLOAT_EQ(inventoryOf(folder.path(), dot + lines).trees.at(1).size.trunkDiameter,
                    static_cast<float>(std::sqrt(421.0) / 100));
    folder.write("a.geojson", treesAsTexts({{"18", "20,15"}, {"16", "12, 14, 9"}, {"15", "20,05"}}));
    EXPECT_TRUE(readInventoryOf(folder.path(), lines));
}

TEST(InventorySizes, AdvisesExpressionsForCodes) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n1,1,low\n2,2,tall\n3,3,tall\n4,4,20\n");
    const std::string lines = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"";
    EXPECT_EQ(readInventoryOf(folder.path(), lines + "h\" }\n").problems().at(0).text(),
              folder.path() +
                  "/a.csv:2: h: expected a size, such as 18, 18 m, 9-12 or >18, found 'low'; the same "
                  "applies to 3 of 4 rows: set inventory.columns.height to an expression that gives "
                  "numbers, such as CASE \"h\" WHEN 'low' THEN 5 ELSE 12 END, or leave it out");
    EXPECT_EQ(inventoryOf(folder.path(),
                          lines + "CASE h WHEN 'low' THEN 5 WHEN 'tall' THEN '9-12' ELSE h END\" }\n")
                  .trees.at(1)
                  .size.height,
              10.5f);
}

TEST(InventorySkip, SkipsAndCountsRowsWithoutAPlace) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n1,1,9\n2,,8\n,,9\n4,4,7\n5,5,6\n");
    const std::string lines = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\n";
    const ForestFile forest = inventoryOf(folder.path(), lines);
    EXPECT_EQ(forest.trees.size(), 3u);
    EXPECT_TRUE(hasPart(notesOf(forest), "a.csv: 2 of 5 rows have no place and are left out, the first: "));
    EXPECT_EQ(readInventoryOf(folder.path(), lines + "skip = false\n").problems().size(), 3u);
}

TEST(InventorySkip, MostRowsWithoutAPlaceAreAProblemUnlessRequested) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n1,1\nleft,2\nright,3\n");
    const std::string lines = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    const auto forest = readInventoryOf(folder.path(), lines);
    ASSERT_FALSE(forest);
    EXPECT_TRUE(hasPart(forest.problems().front().text(),
                        "the same applies to 2 of 3 rows: to leave them out, set inventory.skip = true"));
    EXPECT_EQ(inventoryOf(folder.path(), lines + "skip = true\n").trees.size(), 1u);
}

TEST(InventorySkip, NoTreesAreAProblem) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n2,,9\n");
    const auto forest = readInventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\n");
    ASSERT_FALSE(forest);
    EXPECT_TRUE(hasPart(forest.problems().front().text(),
                        "a.csv:2: y: expected a number, found nothing; no row has a place"));
}

TEST(InventoryPlaces, ReportsAnOutlier) {
    const TemporaryFolder folder;
    std::string rows = "x,y\n";
    for (int i = 0; i < 30; ++i)
        rows += std::to_string(i % 6) + ',' + std::to_string(10 * i) + '\n';
    const std::string lines = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    folder.write("a.csv", rows);
    EXPECT_EQ(notesOf(inventoryOf(folder.path(), lines)).find("km from"), std::string::npos);
    folder.write("a.csv", rows + "40000,50\n3,3\n");
    const std::string notes = notesOf(inventoryOf(folder.path(), lines));
    EXPECT_TRUE(hasPart(
        notes, "line 32: this tree stands 40 km from the middle of the others, which are within 1 km"));
    folder.write("a.csv", rows + "400000,50\n3,3\n");
    const auto tooFar = readInventoryOf(folder.path(), lines);
    ASSERT_FALSE(tooFar);
    EXPECT_TRUE(hasPart(tooFar.problems().front().text(), "a.csv: line 32: this tree stands 400 km"));
}

TEST(InventorySizes, HaveTheUnitsInTheNamesOfTheirColumns) {
    const TemporaryFolder folder;
    folder.write("a.csv", "X,Y,Height (ft),DBH_in,Crown [yd],note\n1,2,60,12,10,a\n5,6,40,8,9,b\n");
    const std::string columns =
        "file = \"a.csv\"\ncolumns = { x = \"X\", y = \"Y\", height = \"Height (ft)\", "
        "trunk_diameter = \"DBH_in\", crown_width = \"Crown [yd]\" }\n";
    const ForestFile named = inventoryOf(folder.path(), columns);
    EXPECT_FLOAT_EQ(named.trees[0].size.height, 18.288f);
    EXPECT_FLOAT_EQ(named.trees[0].size.trunkDiameter, 0.3048f);
    EXPECT_FLOAT_EQ(named.trees[0].size.crownWidth, 9.144f);
    EXPECT_TRUE(hasPart(notesOf(named), "columns give their units, unless inventory.units does: "
                                        "\"Height (ft)\", \"DBH_in\", \"Crown [yd]\""))
        << notesOf(named);
    const ForestFile asked =
        inventoryOf(folder.path(), columns + "units = { height = \"us-ft\", trunk_diameter = "
                                             "\"in\", crown_width = \"ft\" }\n");
    EXPECT_FLOAT_EQ(asked.trees[0].size.height, 60.0f * 1200.0f / 3937.0f);
    EXPECT_FLOAT_EQ(asked.trees[0].size.crownWidth, 3.048f);
    EXPECT_TRUE(hasPart(notesOf(asked), "inventory.units replaces the units of columns: \"Height (ft)\", "
                                        "\"Crown [yd]\""))
        << notesOf(asked);
}

TEST(InventorySizes, HaveTheUnitsInARowBelowTheHeader) {
    const TemporaryFolder folder;
    folder.write("a.csv", "X,Y,Height,DBH\n(m),(m),(ft),in\n1,2,60,12\n5,6,40,8\n");
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { x = \"X\", y = \"Y\", height = \"Height\", "
                                   "trunk_diameter = \"DBH\" }\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_FLOAT_EQ(forest.trees[0].size.height, 18.288f);
    EXPECT_FLOAT_EQ(forest.trees[0].size.trunkDiameter, 0.3048f);
}

TEST(InventorySizes, AreInMetresIfTheNameEndsInNoUnit) {
    const TemporaryFolder folder;
    folder.write("a.csv", "X,Y,Height (est.)\n1,2,18\n5,6,12\n");
    const ForestFile forest = inventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"X\", y = \"Y\", height = \"Height (est.)\" }\n");
    EXPECT_FLOAT_EQ(forest.trees[0].size.height, 18.0f);
    EXPECT_TRUE(hasPart(notesOf(forest),
                        "columns give no known unit, and metres are assumed, unless inventory.units sets "
                        "another: \"Height (est.)\""))
        << notesOf(forest);
}

} // namespace osgTreeWind
