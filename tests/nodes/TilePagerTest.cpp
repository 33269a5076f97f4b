// SPDX-License-Identifier: MIT
// A tiled forest with OSG's pager, without a context.
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/TileReader.h>
#include <tests/MessageCollector.h>
#ifndef _WIN32
#include <tests/nodes/FileServer.h>
#endif
#include <tests/nodes/TiledWorld.h>

#include <osgDB/Registry>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <fstream>
#include <set>

using namespace osgTreeWind;

TEST(TilePagerTest, LoadsOnlyTreesInRange) {
    TiledWorld world;
    EXPECT_EQ(world.forest().getNumTrees(), 0u);
    world.frames(world.at(550.0, 450.0), settleFrames);
    const std::set<std::string> names = world.names();
    // From the middle of a tile its borders are 50 m away: the eight neighbours are in range.
    EXPECT_EQ(names.size(), 81u);
    EXPECT_TRUE(names.count("15/12"));
    EXPECT_TRUE(names.count("20/16"));
    EXPECT_FALSE(names.count("21/12"));
}

TEST(TilePagerTest, ReloadedTreesAreTheSame) {
    TiledWorld world;
    world.frames(world.at(50.0, 50.0), settleFrames);
    const std::optional<TreePlacement> before = world.forest().getPlacement(*world.forest().findTree("2/1"));
    ASSERT_TRUE(before);
    world.frames(world.at(950.0, 950.0), settleFrames);
    EXPECT_EQ(world.names().count("2/1"), 0u);
    EXPECT_TRUE(world.forest().findTree("29/29"));
    world.frames(world.at(50.0, 50.0), settleFrames);
    const std::optional<TreePlacement> after = world.forest().getPlacement(*world.forest().findTree("2/1"));
    ASSERT_TRUE(after);
    EXPECT_EQ(after->position, before->position);
    EXPECT_EQ(after->seed, before->seed);
    EXPECT_EQ(after->size.height, before->size.height);
    EXPECT_EQ(world.names().count("29/29"), 0u);
}

TEST(TilePagerTest, AShortWayBackReloadsNothing) {
    TiledWorld world;
    world.frames(world.at(550.0, 450.0), settleFrames);
    const std::optional<TreeId> found = world.forest().findTree("15/12");
    ASSERT_TRUE(found);
    const TreeId tree = *found;
    world.frames(world.at(950.0, 450.0), 20);
    world.frames(world.at(550.0, 450.0), 20);
    EXPECT_EQ(world.forest().findTree("15/12"), tree) << "it was not unloaded";
}

TEST(TilePagerTest, AMissingTileIsRetried) {
    TiledWorld world;
    const std::string file = world.tile("5_4"), aside = world.folder().path() + "/aside";
    std::filesystem::rename(file, aside);
    const ScopedMessages messages;
    world.frames(world.at(550.0, 450.0), settleFrames);
    EXPECT_EQ(world.names().size(), 72u);
    const std::string warnings = messages.take();
    EXPECT_NE(warnings.find("5_4.trees"), std::string::npos) << warnings;
    EXPECT_LE(std::count(warnings.begin(), warnings.end(), '\n'), 4) << "not one per frame:\n" << warnings;
    std::filesystem::rename(aside, file);
    world.frames(world.at(550.0, 450.0), 200);
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, ATruncatedTileIsRetried) {
    TiledWorld world;
    const std::string file = world.tile("5_4");
    std::ostringstream whole;
    whole << std::ifstream(file).rdbuf();
    const std::string text = whole.str();
    const ScopedMessages messages;
    // In the middle of a row, and between two rows.
    for (const std::size_t size : {text.size() - 7, text.rfind('\n', text.size() - 2) + 1}) {
        std::ofstream(file) << text.substr(0, size);
        world.frames(world.at(550.0, 450.0), settleFrames);
        EXPECT_EQ(world.names().size(), 72u);
        EXPECT_NE(messages.take().find("5_4.trees"), std::string::npos);
        world.frames(world.at(50.0, 50.0), settleFrames);
    }
    std::ofstream(file) << text;
    world.frames(world.at(550.0, 450.0), 200);
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, ACopyLoadsItsOwnTiles) {
    TiledWorld world;
    world.frames(world.at(550.0, 450.0), settleFrames);
    const osg::ref_ptr<Forest> copy = osg::clone(&world.forest(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(copy->getNumTrees(), 0u);
    world.frames(*copy, world.at(50.0, 50.0), settleFrames);
    EXPECT_EQ(TiledWorld::namesOf(*copy).size(), 36u) << "a corner, and its three neighbours";
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, TreesOfTheHostStay) {
    TiledWorld world;
    TreePlacement own;
    own.position = {550.0, 450.0, 0.0};
    own.name = "mine";
    ASSERT_TRUE(world.forest().addTree(own));
    world.frames(world.at(550.0, 450.0), settleFrames);
    world.frames(world.at(950.0, 950.0), settleFrames);
    EXPECT_TRUE(world.forest().findTree("mine"));
    const ForestDescription now = world.forest().getSimulation().currentDescription();
    ASSERT_EQ(now.trees.size(), 1u) << "trees of tiles are not listed";
    EXPECT_TRUE(now.tiles);
}

TEST(TilePagerTest, ALoadedTreeSwaysAsIfItHadBeenThere) {
    TiledWorld world;
    std::istringstream text("version = 1\n[wind]\nkind = \"gusts\"\nspeed = 9.0\ndirection_from = 250.0\n"
                            "[[tree]]\nposition = [0.0, 0.0]\n");
    const WindFieldPtr gusts = readForest(text).value().wind.field;
    EXPECT_TRUE(world.forest().setWind({gusts, WindFrame::Forest}).empty());
    world.frames(world.at(950.0, 950.0), 500);
    world.frames(world.at(250.0, 250.0), 5);

    Result<ForestFile> all = readForestFile(world.folder().path() + "/world.treewind");
    ASSERT_TRUE(loadTiles(all.value()));
    all.value().wind = gusts;
    SimulationOptions options;
    options.distant = true;
    ForestSimulation whole(all.value(), options);
    for (int frame = 1; frame <= 505; ++frame)
        whole.advance(0.1 * frame);
    double difference = 0.0, sway = 0.0;
    for (const TreeId tree : world.forest().getTrees()) {
        const std::string name = world.forest().getSimulation().nameOf(tree);
        const ForestSimulation& here = world.forest().getSimulation();
        const glm::vec2 lean = movingForest(here).modal()->lean(slotOfTree(tree)),
                        expected = movingForest(whole).modal()->lean(slotOfTree(*whole.findTree(name)));
        difference += static_cast<double>(glm::dot(lean - expected, lean - expected));
        sway += static_cast<double>(glm::dot(expected, expected));
    }
    ASSERT_GT(sway, 0.0);
    EXPECT_LT(std::sqrt(difference / sway), 0.05);
}

#ifndef _WIN32 // where OSG is built without its plugin curl, and this server would need sockets of Windows
TEST(TilePagerTest, LoadsFromAServer) {
    TiledWorld world;
    const FileServer server(world.folder().path());
    world.readFrom(server.url() + "/tiles");
    world.frames(world.at(550.0, 450.0), settleFrames);
    EXPECT_EQ(world.names().size(), 81u);
    EXPECT_TRUE(world.forest().findTree("15/12"));
}

TEST(TilePagerTest, RetriesAServerThatFailsSometimes) {
    TiledWorld world;
    FileServer server(world.folder().path());
    server.failOneIn(4);
    world.readFrom(server.url() + "/tiles");
    const ScopedMessages messages;
    world.frames(world.at(550.0, 450.0), 10);
    world.frames(world.at(250.0, 250.0), settleFrames);
    world.frames(world.at(550.0, 450.0), 400);
    EXPECT_GE(server.failures(), 3) << "each way of failing once";
    EXPECT_EQ(world.names().size(), 81u) << messages.take();
}

TEST(TilePagerTest, ASilentServerTimesOut) {
    TiledWorld world;
    const SilentServer server;
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("OSG_CURL_TIMEOUT=1");
    osgDB::Registry::instance()->setOptions(options);
    world.readFrom(server.url() + "/tiles");
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(world.forest().findTree("5_4/1"));
    osgDB::Registry::instance()->setOptions(nullptr);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(TilePagerTest, AHugeFileOfAServerIsRejected) {
    struct Endless : std::streambuf {
        off_type at = 0;
        pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
            constexpr off_type size = off_type(1) << 40;
            return at = offset + (from == std::ios::end ? size : from == std::ios::cur ? at : 0);
        }
        pos_type seekpos(pos_type to, std::ios::openmode) override { return at = to; }
    } endless;
    std::istream input(&endless);
    registerTileReader();
    osgDB::ReaderWriter* reader = osgDB::Registry::instance()->getReaderWriterForExtension("trees");
    ASSERT_TRUE(reader);
    EXPECT_NE(reader->readNode(input, nullptr).message().find("expected at most 256 MiB"), std::string::npos);
}
#endif
