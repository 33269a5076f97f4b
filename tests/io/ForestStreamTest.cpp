// SPDX-License-Identifier: MIT
// Compares a forest read as a stream with the same forest read at once.
#include <tests/base/IsProblem.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestStream.h>
#include <osgTreeWind/io/TiledForest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Trees of all sections on a slope, some with ids, one id twice, far from the map's origin. Their species do
/// not grow by light, because a stream does not support growing spaces.
std::string variedFile(const TemporaryFolder& folder) {
    RasterFile slope;
    slope.columns = slope.rows = 100;
    slope.transform = {690000, 10, 0, 5335000, 0, -10};
    slope.value = [](int column, int) { return 500.0 + 2.0 * column; };
    slope.write(folder.path() + "/slope.tif");
    folder.write("trees.csv", "id,x,y,z,h,art\na,690100,5334100,519,12,oak\nb,690200,5334200,,,birch\n"
                              "a,690300,5334300,,9,\"a tree,\nunheard of\"\n,690400,5334400,,11,oak\n");
    std::string species;
    for (const std::string name : {"oak", "birch", "beech", "lime", "Norway spruce"})
        species += "[[species]]\nname = \"" + name + "\"\nlike = \"" + name + "\"\n[species.tree]\n";
    return folder.write(
        "forest.treewind",
        "version = 1\nseason = \"autumn\"\n[wind]\nkind = \"uniform\"\nvelocity = [6, 0, 0]\n"
        "[ground]\nfile = \"slope.tif\"\n"
        "[[tree]]\nspecies = \"beech\"\nposition = [690050, 5334050, 3]\nid = \"first\"\nleaves = 0.5\n"
        "[[tree]]\nspecies = \"oak\"\nposition = [690060, 5334050]\nopen_grown = true\n"
        "[[scatter]]\ncount = 300\narea = [690000, 5334010, 690900, 5334990]\nspecies = [\"oak\", \"Norway "
        "spruce\"]\nspacing = 3\nheight = [5, 30]\n"
        "[[inventory]]\nfile = \"trees.csv\"\ndefault_species = \"lime\"\n"
        "columns = { id = \"id\", x = \"x\", y = \"y\", z = \"z\", height = \"h\", species = \"art\" }\n" +
            species);
}

ForestStream streamOf(const std::string& file, const TemporaryFolder& folder, std::size_t treesAtOnce) {
    ForestStreamOptions options;
    options.folder = folder.path();
    options.treesAtOnce = treesAtOnce;
    auto stream = ForestStream::read(file, options);
    for (const Diagnostic& problem : stream.problems())
        ADD_FAILURE() << problem.text();
    return stream ? std::move(stream.value()) : ForestStream();
}

std::vector<std::string> textsOf(const Diagnostics& problems) {
    std::vector<std::string> texts;
    for (const Diagnostic& problem : problems)
        texts.push_back(problem.text());
    return texts;
}

} // namespace

TEST(ForestStreamTest, treesEqualThoseReadAtOnce) {
    const TemporaryFolder folder;
    const std::string file = variedFile(folder);
    const ForestFile whole = readForestFile(file).value();
    ASSERT_EQ(whole.trees.size(), 306u);
    for (const std::size_t atOnce : {1u, 7u, 306u, 100000u}) {
        const ForestStream stream = streamOf(file, folder, atOnce);
        ASSERT_EQ(stream.treeCount(), 306u);
        EXPECT_TRUE(stream.file().trees.empty());
        EXPECT_EQ(stream.file().origin, whole.origin);
        EXPECT_EQ(stream.file().notes, whole.notes);
        ASSERT_EQ(stream.file().species.size(), whole.species.size());
        std::size_t i = 0;
        for (int pass = 0; pass < 2; ++pass, i = 0) {
            ASSERT_TRUE(stream.visit([&](const std::vector<TreePlacement>& trees) {
                EXPECT_LE(trees.size(), atOnce);
                for (const TreePlacement& tree : trees) {
                    const TreePlacement& other = whole.trees[i++];
                    EXPECT_EQ(tree.species, other.species);
                    EXPECT_EQ(tree.position, other.position) << i;
                    EXPECT_EQ(tree.heading, other.heading);
                    EXPECT_EQ(tree.size.height, other.size.height);
                    EXPECT_EQ(tree.size.trunkDiameter, other.size.trunkDiameter);
                    EXPECT_EQ(tree.size.crownWidth, other.size.crownWidth);
                    EXPECT_EQ(tree.leaves, other.leaves);
                    EXPECT_EQ(tree.seed, other.seed);
                    EXPECT_EQ(tree.openGrown, other.openGrown);
                    EXPECT_EQ(tree.name, other.name);
                    EXPECT_EQ(tree.estimated.height, other.estimated.height);
                    EXPECT_EQ(tree.estimated.trunkDiameter, other.estimated.trunkDiameter);
                    EXPECT_EQ(tree.estimated.crownWidth, other.estimated.crownWidth);
                }
            }));
            EXPECT_EQ(i, 306u);
        }
    }
}

TEST(ForestStreamTest, aFileThatIsReadInOnePassLeavesNoTreesInMemory) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("plain.treewind", "version = 1\norigin = [0, 0, 0]\n[[species]]\nname = \"a\"\n"
                                       "[[tree]]\nposition = [1, 2, 0]\n[[tree]]\nposition = [9, 2, 0]\n");
    for (const std::size_t atOnce : {1u, 100000u}) {
        const ForestStream stream = streamOf(file, folder, atOnce);
        EXPECT_EQ(stream.treeCount(), 2u);
        EXPECT_TRUE(stream.file().trees.empty()) << atOnce;
    }
}

TEST(ForestStreamTest, tiledFilesEqualThoseOfTheWholeForest) {
    const TemporaryFolder folder, worlds;
    const std::string file = variedFile(folder);
    ASSERT_TRUE(writeTiledForest(readForestFile(file).value(), worlds.path() + "/whole"));
    const auto expected = filesOf(worlds.path() + "/whole");
    ASSERT_GT(expected.count("tiles/0.ids"), 0u);
    for (const std::size_t atOnce : {7u, 100000u}) {
        const std::string world = worlds.path() + '/' + std::to_string(atOnce);
        ASSERT_TRUE(writeTiledForest(streamOf(file, folder, atOnce), world));
        EXPECT_EQ(filesOf(world), expected) << atOnce;
    }
}

TEST(ForestStreamTest, problemsEqualThoseOfTheWholeForest) {
    const TemporaryFolder folder;
    variedFile(folder);
    ForestStreamOptions options;
    options.folder = folder.path();
    options.treesAtOnce = 5;
    const std::string head = "version = 1\n[[scatter]]\ncount = 20\n", oak = "species = \"oak\"\n";
    for (const std::string& text :
         {head + oak + "area = [690900, 5334100, 691100, 5334900]\n[ground]\nfile = \"slope.tif\"\n",
          head + oak + "area = [0, 0, 900000, 9]\norigin = [0, 0, 0]\n",
          "version = 1\norigin = [0, 0, 0]\n[[scatter]]\ncount = 20\narea = [0, 0, 900000, 9]\n" + oak,
          head + "species = \"okay\"\narea = [0, 0, 9, 9]\n",
          head + oak + "area = [0, 0, 9, 9]\n[[inventory]]\nfile = \"trees.csv\"\n", std::string()}) {
        const std::string file = folder.write("bad.treewind", text);
        const auto whole = readForestFile(file);
        const auto stream = ForestStream::read(file, options);
        ASSERT_FALSE(whole) << text;
        ASSERT_FALSE(stream) << text;
        EXPECT_EQ(textsOf(stream.problems()), textsOf(whole.problems()));
    }
    options.maxTrees = 10;
    const auto many = ForestStream::read(folder.path() + "/forest.treewind", options);
    ASSERT_FALSE(many);
    EXPECT_TRUE(hasPart(many.problems().front().text(), "more than 10 trees in all"));
}

TEST(ForestStreamTest, reportsAFolderThatCannotHoldTheTrees) {
    const TemporaryFolder folder;
    const std::string file = variedFile(folder);
    const auto stream = ForestStream::read(file, {folder.path() + "/nowhere"});
    ASSERT_FALSE(stream);
    EXPECT_EQ(textsOf(stream.problems()), std::vector{folder.path() + "/nowhere: cannot be written"});
    ForestStreamOptions options;
    options.folder = folder.path();
    ASSERT_TRUE(ForestStream::read(file, options));
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/trees.part")) << "the temporary file is removed";
}

} // namespace osgTreeWind
