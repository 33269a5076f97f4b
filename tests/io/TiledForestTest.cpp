// SPDX-License-Identifier: MIT
// Writes a forest as tiles and reads it back.
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TileTrees.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/system/FolderLock.h>
#include <tests/base/IsProblem.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <sstream>

using namespace osgTreeWind;
namespace fs = std::filesystem;

namespace {

/// Varied trees on 3 x 2 km of a map, far from its origin.
ForestDescription variedForest(int count) {
    std::istringstream text("version = 1\norigin = [691000.0, 5334500.0, 510.0]\n"
                            "[wind]\nkind = \"uniform\"\nvelocity = [6.0, 0.0, 0.0]\n"
                            "[[scatter]]\ncount = 1\narea = [690000.0, 5334000.0, 690001.0, 5334001.0]\n"
                            "species = [\"oak\", \"birch\", \"Norway spruce\"]\n");
    ForestFile forest = readForest(text).value();
    std::istringstream all("version = 1\n[[tree]]\nspecies = \"oak\"\nposition = [0.0, 0.0]\n"
                           "[[tree]]\nspecies = \"Norway spruce\"\nposition = [0.0, 0.0]\n");
    forest.species = readForest(all).value().species;
    forest.trees.clear();
    std::mt19937 random(5);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int i = 0; i < count; ++i) {
        TreePlacement tree;
        tree.species = random() % 2;
        tree.position = {uniform(689500.0, 692500.0), uniform(5334000.0, 5336000.0), uniform(500.0, 560.0)};
        tree.heading = static_cast<float>(uniform(-7.0, 7.0));
        if (random() % 4 > 0)
            tree.size.height = static_cast<float>(uniform(3.0, 40.0));
        if (random() % 2 > 0)
            tree.size.trunkDiameter = static_cast<float>(uniform(0.05, 1.2));
        if (random() % 3 == 0)
            tree.size.crownWidth = static_cast<float>(uniform(1.0, 15.0));
        if (random() % 5 == 0)
            tree.leaves = static_cast<float>(uniform(0.0, 1.0));
        tree.seed = random();
        tree.openGrown = random() % 3 == 0;
        tree.estimated = {random() % 2 == 0, random() % 2 == 0, random() % 2 == 0};
        tree.name = i % 3 == 0 ? "" : "no. \"" + std::to_string(i) + "\", street";
        forest.trees.push_back(tree);
    }
    return forest;
}

TilingOptions ofSize(double metres) {
    TilingOptions options;
    options.size = metres;
    return options;
}

bool isSameTree(const TreePlacement& a, const TreePlacement& b) {
    return a.species == b.species && std::abs(std::sin(0.5f * (a.heading - b.heading))) < 1e-6f &&
           a.size.height == b.size.height && a.size.trunkDiameter == b.size.trunkDiameter &&
           a.size.crownWidth == b.size.crownWidth && a.leaves == b.leaves && a.seed == b.seed &&
           a.openGrown == b.openGrown && a.estimated.height == b.estimated.height &&
           a.estimated.crownWidth == b.estimated.crownWidth &&
           a.estimated.trunkDiameter == b.estimated.trunkDiameter &&
           glm::distance(a.position, b.position) < 1e-4;
}

ForestDescription worldOf(const std::string& folder) {
    auto world = readForestFile(folder + "/world.treewind");
    EXPECT_TRUE(world) << world.problems().front().text();
    return world.value();
}

} // namespace

TEST(TiledForestTest, allTreesReadBack) {
    const TemporaryFolder folder;
    const ForestDescription forest = variedForest(3000);
    const auto tiles = writeTiledForest(forest, folder.path() + "/world", ofSize(500.0));
    ASSERT_TRUE(tiles) << tiles.problems().front().text();
    EXPECT_EQ(tiles.value().columns, 6u);
    EXPECT_EQ(tiles.value().rows(), 4u);
    EXPECT_EQ(tiles.value().treeCount(), 3000u);

    ForestDescription world = worldOf(folder.path() + "/world");
    EXPECT_TRUE(world.trees.empty());
    ASSERT_TRUE(world.tiles);
    EXPECT_EQ(world.tiles->treeCount(), 3000u);
    EXPECT_EQ(world.origin, forest.origin);
    const Diagnostics problems = loadTiles(world).problems();
    ASSERT_TRUE(problems.empty()) << problems.front().text();
    EXPECT_FALSE(world.tiles);
    ASSERT_EQ(world.trees.size(), 3000u);
    std::map<std::uint32_t, TreePlacement> bySeed;
    for (const TreePlacement& tree : world.trees)
        bySeed[tree.seed] = tree;
    for (const TreePlacement& tree : forest.trees) {
        ASSERT_TRUE(isSameTree(bySeed[tree.seed], tree)) << tree.seed;
        EXPECT_TRUE(tree.name.empty() || bySeed[tree.seed].name == tree.name) << tree.name;
    }
}

TEST(TiledForestTest, writesAFlightPath) {
    const TemporaryFolder folder;
    const auto tiles = writeTiledForest(variedForest(300), folder.path());
    ASSERT_TRUE(tiles);
    std::istringstream path(bytesOf(folder.path() + "/fly.path"));
    double time = -1.0, next = 0.0;
    glm::dvec3 eye(0.0), before(0.0);
    glm::dquat rotation;
    int count = 0;
    for (; path >> next >> eye.x >> eye.y >> eye.z >> rotation.x >> rotation.y >> rotation.z >> rotation.w;
         ++count, before = eye, time = next) {
        EXPECT_GT(next, time);
        const glm::dvec2 at =
            glm::dvec2(eye) + glm::dvec2(691000.0, 5334500.0); // relative to the forest's origin
        EXPECT_TRUE(at.x > 689500.0 && at.x < 692500.0 && at.y > 5334000.0 && at.y < 5336000.0);
        EXPECT_GT(eye.z + 510.0, 560.0) << "above all feet";
        const glm::dvec3 ahead = rotation * glm::dvec3(0.0, 0.0, -1.0),
                         up = rotation * glm::dvec3(0.0, 1.0, 0.0);
        EXPECT_LT(ahead.z, 0.0);
        EXPECT_GT(up.z, 0.9);
        if (count > 0) {
            EXPECT_GT(glm::dot(glm::normalize(eye - before), ahead), 0.5) << "it looks about where it flies";
        }
    }
    EXPECT_TRUE(path.eof());
    EXPECT_GE(count, 24);
    EXPECT_NEAR(time * 50.0, 4844.0, 200.0) << "once around an ellipse of 1000 m by 500 m";
}

TEST(TiledForestTest, treesWithoutAnIdAreNamedByTheirTile) {
    const TemporaryFolder folder;
    ForestDescription forest = variedForest(30);
    for (TreePlacement& tree : forest.trees)
        tree.name.clear();
    ASSERT_TRUE(writeTiledForest(forest, folder.path(), ofSize(1000.0)));
    ForestDescription world = worldOf(folder.path());
    ASSERT_TRUE(loadTiles(world, {1, 1, 1, 1}));
    ASSERT_FALSE(world.trees.empty());
    for (std::size_t i = 0; i < world.trees.size(); ++i)
        EXPECT_EQ(world.trees[i].name, "1_1/" + std::to_string(i));
}

TEST(TiledForestTest, loadsEachTreeOnceAndTheNeighbours) {
    const TemporaryFolder folder;
    const ForestDescription forest = variedForest(3000);
    ASSERT_TRUE(writeTiledForest(forest, folder.path(), ofSize(500.0)));
    ForestDescription edited = worldOf(folder.path());
    TreePlacement own = forest.trees[0];
    for (const double x : {680000.0, 690100.0, 700000.0}) { // two outside of the tiles
        own.position = {x, 5335100.0, 500.0};
        own.name = "own " + std::to_string(edited.trees.size());
        edited.trees.push_back(own);
    }
    std::map<std::string, int> met;
    std::size_t count = 0;
    for (const TileBox& box :
         {TileBox{0, 0, 1, 3}, TileBox{2, 0, 2, 1}, TileBox{2, 2, 2, 3}, TileBox{3, 0, ~0u, ~0u}}) {
        ForestDescription part = edited;
        const Result<std::size_t> wanted = loadTiles(part, box, 200.0);
        ASSERT_TRUE(wanted) << wanted.problems().front().text();
        count += wanted.value();
        for (std::size_t i = 0; i < part.trees.size(); ++i) {
            const double x = (part.trees[i].position.x - 689500.0) / 500.0;
            if (i < wanted.value())
                ++met[part.trees[i].name];
            else
                EXPECT_TRUE(x >= box.firstColumn - 0.401 && x <= std::min(box.lastColumn, 9u) + 1.401) << x;
        }
        EXPECT_GT(part.trees.size(), wanted.value() + 50) << "neighbours are included";
    }
    EXPECT_EQ(count, 3003u);
    EXPECT_EQ(met.size(), 3003u);
    ForestDescription none = edited;
    const Result<std::size_t> beyond = loadTiles(none, {6, 0, 7, 0});
    ASSERT_FALSE(beyond);
    EXPECT_TRUE(isProblem(beyond.problems().front().text(), "tiles", "found 6,0"));
}

TEST(TiledForestTest, filesDoNotDependOnThreads) {
    const TemporaryFolder folder;
    const ForestDescription forest = variedForest(1000);
    ASSERT_TRUE(writeTiledForest(forest, folder.path() + "/one", ofSize(300.0)));
    TilingOptions threaded = ofSize(300.0);
    threaded.executor = ThreadPool::executor(4);
    ASSERT_TRUE(writeTiledForest(forest, folder.path() + "/four", threaded));
    EXPECT_EQ(filesOf(folder.path() + "/one"), filesOf(folder.path() + "/four"));
}

TEST(TiledForestTest, rewritingRemovesTheOldTiles) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(variedForest(1000), folder.path() + "/a", ofSize(300.0)));
    ASSERT_TRUE(writeTiledForest(variedForest(20), folder.path() + "/a", ofSize(300.0)));
    EXPECT_FALSE(fs::exists(folder.path() + "/a/tiles")) << "the second world is in tiles-2";
    EXPECT_EQ(readForestFile(folder.path() + "/a/world.treewind").value().tiles->treeCount(), 20u);
    ASSERT_TRUE(writeTiledForest(variedForest(10), folder.path() + "/a", ofSize(300.0)));
    ASSERT_TRUE(writeTiledForest(variedForest(10), folder.path() + "/b", ofSize(300.0)));
    EXPECT_EQ(filesOf(folder.path() + "/a"), filesOf(folder.path() + "/b"));
}

TEST(TiledForestTest, rewritingRemovesTheOldTilesHoweverTheFolderIsNamed) {
    const TemporaryFolder folder;
    const std::string world = folder.path() + "/world", link = folder.path() + "/link";
    ASSERT_TRUE(writeTiledForest(variedForest(20), world, ofSize(300.0)));
    std::vector<std::string> names = {world, world + '/'};
#ifndef _WIN32 // where links need a right, and the temporary folder may be on another drive
    fs::create_directory_symlink(world, link);
    names.insert(names.end(), {fs::relative(world).string(), link, fs::relative(link).string() + '/'});
#endif
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(writeTiledForest(variedForest(20), name, ofSize(300.0)));
        const std::string used = readForestFile(world + "/world.treewind").value().tiles->folder;
        EXPECT_TRUE(fs::is_directory(used));
        EXPECT_NE(fs::exists(world + "/tiles"), fs::exists(world + "/tiles-2")) << "only one of them is left";
    }
}

TEST(TiledForestTest, keepsForeignFolders) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() + "/tiles");
    folder.write("tiles/photo.jpg", "mine");
    const auto tiles = writeTiledForest(variedForest(10), folder.path());
    ASSERT_FALSE(tiles);
    EXPECT_TRUE(isProblem(tiles.problems().front().text(), folder.path() + "/tiles", "found photo.jpg"));
    EXPECT_EQ(bytesOf(folder.path() + "/tiles/photo.jpg"), "mine");
}

TEST(TiledForestTest, keepsTheOldWorldUntilTheNewOneIsComplete) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(variedForest(10), folder.path()));
    folder.write("tiles-2", "a file where the folder should be");
    const auto before = filesOf(folder.path());
    const auto tiles = writeTiledForest(variedForest(20), folder.path());
    ASSERT_FALSE(tiles);
    EXPECT_TRUE(isProblem(tiles.problems().front().text(), folder.path() + "/tiles-2", "a folder of tiles"));
    EXPECT_EQ(filesOf(folder.path()), before);
}

TEST(TiledForestTest, doesNotOverwriteAForestWithoutTiles) {
    const TemporaryFolder folder;
    const std::string file = folder.write("world.treewind", "version = 1\n[[tree]]\nposition = [0, 0]\n");
    const auto before = filesOf(folder.path());
    const auto tiles = writeTiledForest(variedForest(20), folder.path());
    ASSERT_FALSE(tiles);
    EXPECT_EQ(tiles.problems().front().file, file);
    EXPECT_EQ(filesOf(folder.path()), before);
}

TEST(TiledForestTest, locksTheFolder) {
    const TemporaryFolder folder;
    auto other = std::make_unique<FolderLock>(folder.path());
    ASSERT_TRUE(other->isHeld());
    EXPECT_TRUE(isProblem(toString(writeTiledForest(variedForest(10), folder.path()).problems()),
                          folder.path(), "another program"));
    other.reset();
    EXPECT_TRUE(writeTiledForest(variedForest(10), folder.path()));
}

TEST(TiledForestTest, limitsTheNumberOfTiles) {
    const TemporaryFolder folder;
    ForestDescription forest = variedForest(100);
    forest.trees[0].position += glm::dvec3(60000.0, 0.0, 0.0);
    const auto tiles = writeTiledForest(forest, folder.path(), ofSize(10.0));
    ASSERT_TRUE(tiles) << tiles.problems().front().text();
    EXPECT_LE(tiles.value().tiles.size(), 10000u);
    EXPECT_GT(tiles.value().size, 10.0);
}

TEST(TiledForestTest, tiledForestReadsBackAfterWriting) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(variedForest(100), folder.path()));
    const ForestDescription world = worldOf(folder.path());
    const std::string copy = folder.path() + "/elsewhere.treewind";
    ASSERT_TRUE(writeForestFile(world, copy).empty());
    const auto again = readForestFile(copy);
    ASSERT_TRUE(again) << again.problems().front().text();
    EXPECT_EQ(again.value().tiles->folder, world.tiles->folder);
    EXPECT_EQ(again.value().tiles->treeCount(), 100u);
    EXPECT_EQ(again.value().tiles->inOpen, world.tiles->inOpen);
}

TEST(TiledForestTest, reportsProblemsOfTheWorld) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(variedForest(100), folder.path()));
    const std::string good = bytesOf(folder.path() + "/world.treewind");
    const std::vector<std::array<std::string, 3>> cases = {
        {"size = 1000", "size = -1", "tiles.size: expected a finite number in [10, 100000], found -1"},
        {"corner = [", "korner = [", "tiles.corner: missing"},
        {"columns = 4", "columns = 5", "tiles.trees: expected"},
        {"rows = 2", "rows = 3", "tiles.trees: expected 3 rows"},
        {"in_forest = [", "in_forest = [\"fern\", ", "tiles.in_forest: no [[species]] \"fern\""},
        {"origin = [", "# origin = [", "origin: missing"},
        {"[motion]\n", "[motion]\nlaw = \"thesis\"\n", "tiles: expected the law \"modal\" with tiles"},
    };
    for (const auto& [from, to, expected] : cases) {
        std::string bad = good;
        ASSERT_NE(bad.find(from), std::string::npos) << from;
        bad.replace(bad.find(from), from.size(), to);
        const auto world = readForestFile(folder.write("bad.treewind", bad));
        ASSERT_FALSE(world) << to;
        const std::string problems = toString(world.problems());
        EXPECT_TRUE(hasPart(problems, expected));
    }
}

TEST(TiledForestTest, reportsProblemsOfATile) {
    const std::string head =
        "species,x,y,z,heading,height,trunk_diameter,crown_width,leaves,seed,open_grown,estimated,id\n";
    const auto problemOf = [&](const std::string& text) {
        std::istringstream input(text);
        const auto trees = readTileTrees(input, "1_2.trees");
        return trees ? std::string() : trees.problems().front().text();
    };
    EXPECT_EQ(problemOf(head + "oak,1,2,3,0.5,12,0.3,5,0.5,7,1,hdw,one\noak,1,2,3,0,,,,,7,,,\n"), "");
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"oak,1,2", "1_2.trees:2:"},
        {",1,2,3,0,,,,,7,,,", "1_2.trees:2: species: expected a name, found nothing"},
        {"oak,nan,2,3,0,,,,,7,,,", "1_2.trees:2: x: expected a number"},
        {"oak,1,2,1e9,0,,,,,7,,,", "1_2.trees:2: z: expected a number"},
        {"oak,1,2,3,3e4,,,,,7,,,", "1_2.trees:2: heading: expected a number"},
        {"oak,1,2,3,0,-4,,,,7,,,", "1_2.trees:2: height: expected a number"},
        {"oak,1,2,3,0,,,,2,7,,,", "1_2.trees:2: leaves: expected a number"},
        {"oak,1,2,3,0,,,,,-7,,,", "1_2.trees:2: seed: expected a number"},
        {"oak,1,2,3,0,,,,,7,yes,,", "1_2.trees:2: open_grown: expected 1 or nothing, found 'yes'"},
        {"oak,1,2,3,0,,,,,7,,x,", "1_2.trees:2: estimated: expected some of h, d and w, found 'x'"},
    };
    for (const auto& [row, expected] : cases)
        EXPECT_EQ(problemOf(head + row + '\n').substr(0, expected.size()), expected) << row;
    EXPECT_TRUE(hasPart(problemOf("x,y\n1,2\n"), "1_2.trees:1: expected the columns species, x"));
    EXPECT_NE(problemOf(""), "");
}

TEST(TiledForestTest, rejectsATileWithMissingTrees) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(variedForest(100), folder.path()));
    ForestDescription world = worldOf(folder.path());
    std::string tile = bytesOf(fileOfTile(*world.tiles, 1));
    tile.erase(tile.rfind('\n', tile.size() - 2) + 1); // the last tree
    folder.write("tiles/1_0.trees", tile);
    const Diagnostics problems = loadTiles(world).problems();
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_TRUE(hasPart(problems.front().text(), "1_0.trees: expected"));
}
