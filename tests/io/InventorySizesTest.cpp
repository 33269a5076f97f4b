// SPDX-License-Identifier: MIT
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

TEST(InventorySizes, StayTheSameInAnyOrderFileAndSeed) {
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

TEST(InventorySizes, FollowTheIdOrElseTheNumberOfTheRow) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\n,1,2,,0.3\n5,1,3,,0.3\n5,1,4,,0.3\n,1,5,,0.3\n2,1,6,,0.3\n");
    const auto trees = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)).trees;
    ASSERT_EQ(trees.size(), 5u);
    const float law = 31.8f * std::pow(0.3f, 0.441f); // beeches in a forest
    EXPECT_NEAR(std::log(trees[0].size.height / law), 0.186 * residual("1", "height"), 1e-5);
    EXPECT_NEAR(std::log(trees[3].size.height / law), 0.186 * residual("4", "height"), 1e-5);
    EXPECT_NEAR(std::log(trees[4].size.height / law), 0.186 * residual("2", "height"), 1e-5);
    EXPECT_EQ(trees[1].size.height, trees[2].size.height) << "of one id";
    EXPECT_TRUE(trees[2].name.empty());
}

TEST(InventorySizes, FollowTheRoomThatTreesHave) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\n");
    const std::string lines = "file = \"a.csv\"\n" + std::string(sizeColumns);
    const TreeSize forest = inventoryOf(folder.path(), lines).trees[0].size;
    const TreeSize open = inventoryOf(folder.path(), lines + "open_grown = true\n").trees[0].size;
    EXPECT_GT(forest.height, open.height);
    EXPECT_LT(forest.crownWidth, open.crownWidth);
}

TEST(InventorySizes, AreSaidInANote) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,\nc,1,3,,\nd,1,3,9,0.3\n");
    const auto notes = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)).notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("a.csv: not given, by the laws of the species: height of 2, trunk diameter of 1, "
                            "crown width of 3 trees"),
              std::string::npos)
        << notes[0];
}

TEST(InventorySizes, AreWrittenAsWhatTheyAre) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,0.3\n");
    const ForestDescription forest =
        inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns));
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

TEST(InventorySizes, StayEstimatedInAForestAsItIsNow) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\nb,1,3,9,0.3\n");
    PlacedForest placed(inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns)));
    const TreePlacement turned = [&] {
        TreePlacement tree = placed.placementOf(0);
        tree.heading = 1.0f;
        return tree;
    }();
    placed.put(0, placed.fitted(turned, &placed.trees[0]), turned.name);
    const auto trees = placed.describe().trees;
    EXPECT_TRUE(trees[0].estimated.height && !trees[0].estimated.trunkDiameter);
    EXPECT_EQ(trees[0].heading, 1.0f);
    EXPECT_FALSE(trees[1].estimated.height);
}

TEST(InventorySizes, OfASpeciesWithoutLawsFollowItsShape) {
    const TemporaryFolder folder;
    folder.write("a.csv", "nr,x,y,h,d\na,1,2,,0.3\n");
    const TreePlacement tree = inventoryOf(folder.path(), "file = \"a.csv\"\n" + std::string(sizeColumns),
                                           "[[species]]\nname = \"beech\"\n")
                                   .trees[0];
    EXPECT_EQ(tree.size.height, 0.0f);
    EXPECT_FALSE(tree.estimated.height);
}

TEST(InventorySizes, BadLawsAreOneErrorWithTheirKey) {
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
        EXPECT_NE(problem.find("test.treewind:5:"), std::string::npos) << problem;
        EXPECT_NE(problem.find(expected), std::string::npos) << problem;
    }
}

TEST(InventorySizes, NoSpeciesAtAllIsAnErrorToo) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,s\n1,2,moon tree\n");
    std::istringstream input("version = 1\nspecies = []\n[inventory]\nfile = \"a.csv\"\n"
                             "columns = { x = \"x\", y = \"y\", species = \"s\" }\n");
    EXPECT_FALSE(readForest(input, {"test.treewind", folder.path()}).ok());
}

TEST(InventorySkip, LeavesOutRowsThatAreNoTreesAndSaysSo) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n1,1,9\n2,2,999\n3,,9\n4,4,-1\n5,5,tall\n6,6,8\n");
    const std::string lines = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\n";
    const auto strict = readInventoryOf(folder.path(), lines);
    ASSERT_FALSE(strict);
    EXPECT_EQ(strict.problems().size(), 4u);

    const ForestDescription forest = inventoryOf(folder.path(), lines + "skip = true\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.trees[1].position.x, 6.0);
    EXPECT_EQ(forest.trees[1].size.height, 8.0f);
    ASSERT_FALSE(forest.notes.empty());
    EXPECT_NE(forest.notes.front().find("a.csv: 4 of 6 rows are no trees and left out, the first: "),
              std::string::npos)
        << forest.notes.front();
    EXPECT_NE(forest.notes.front().find("a.csv:3: "), std::string::npos) << forest.notes.front();
}

/// 999 is what some inventories write for what they do not know.
TEST(InventorySkip, ATrunkOfTenMetresIsNoTrees) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,d\n1,1,0.4\n2,2,9.99\n3,3,4.9\n");
    const std::string lines =
        "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", trunk_diameter = \"d\" }\n";
    const auto strict = readInventoryOf(folder.path(), lines);
    ASSERT_FALSE(strict);
    ASSERT_EQ(strict.problems().size(), 1u);
    EXPECT_NE(strict.problems().front().text().find(
                  "a.csv:3: a trunk of 9.99 m is that of no beech: such a tree would be 149.85 m high"),
              std::string::npos)
        << strict.problems().front().text();
    EXPECT_EQ(inventoryOf(folder.path(), lines + "skip = true\n").trees.size(), 2u);
}

TEST(InventorySkip, NoTreesAtAllAreStillAProblem) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n2,2,999\n");
    const auto forest = readInventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\nskip = true\n");
    ASSERT_FALSE(forest);
    EXPECT_NE(forest.problems().front().text().find("an inventory without trees: no row is one; the first: "),
              std::string::npos);
}

} // namespace osgTreeWind
