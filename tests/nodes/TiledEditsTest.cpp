// SPDX-License-Identifier: MIT
// Changes of trees in loaded and unloaded tiles.
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <tests/MessageCollector.h>
#include <tests/nodes/TiledWorld.h>

#include <filesystem>
#include <fstream>

using namespace osgTreeWind;

namespace {

const char* const nearTree = "15/12"; // a tree of tile 5_4

void unloadAndReload(TiledWorld& world) {
    world.frames(world.at(50.0, 50.0), settleFrames);
    ASSERT_EQ(world.names().count("0/0"), 1u);
    world.frames(world.at(550.0, 450.0), settleFrames);
}

} // namespace

TEST(TiledEditsTest, ARemovedTreeDoesNotComeBack) {
    TiledWorld world;
    world.frames(world.at(550.0, 450.0), settleFrames);
    ASSERT_TRUE(world.forest().removeTree(*world.forest().findTree(nearTree)).empty());
    unloadAndReload(world);
    EXPECT_EQ(world.names().size(), 80u);
    EXPECT_EQ(world.names().count(nearTree), 0u);
    EXPECT_FALSE(world.forest().findTree(nearTree));
}

TEST(TiledEditsTest, FindsATreeInATileThatIsNotLoaded) {
    TiledWorld world;
    const std::optional<TreeId> found = world.forest().findTree(nearTree);
    ASSERT_TRUE(found);
    const TreeId tree = *found;
    EXPECT_EQ(world.names().size(), 9u) << "with its tile";
    EXPECT_EQ(world.forest().getPlacement(tree)->seed, 30u * 15 + 12);
    ASSERT_TRUE(world.forest().removeTree(tree).empty());
    EXPECT_FALSE(world.forest().findTree("nobody"));
    world.frames(world.at(50.0, 50.0), settleFrames);
    EXPECT_EQ(world.names().size(), 36u) << "the tile of the removed tree is unloaded again";
    world.frames(world.at(550.0, 450.0), settleFrames);
    EXPECT_EQ(world.names().size(), 80u);
}

TEST(TiledEditsTest, FindsATreeWithoutANameByItsTile) {
    ForestDescription forest = smallForest(12);
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTiledForest(forest, folder.path()));
    const osg::ref_ptr<Forest> world = new Forest(readForestFile(folder.path() + "/world.treewind").value());
    const std::optional<TreeId> found = world->findTree("0_0/7");
    ASSERT_TRUE(found);
    const TreeId tree = *found;
    EXPECT_EQ(world->getPlacement(tree)->seed, 7u);
    for (const char* name : {"0_0/12", "1_0/0", "0_0/", "0_0/7x", "0_0", "-1_0/0", ""})
        EXPECT_FALSE(world->findTree(name)) << name;
}

TEST(TiledEditsTest, AChangedTreeStaysChanged) {
    TiledWorld world;
    const std::optional<TreeId> found = world.forest().findTree(nearTree);
    ASSERT_TRUE(found);
    const TreeId tree = *found;
    TreePlacement taller = *world.forest().getPlacement(tree);
    taller.position.x += 2.0;
    taller.size = {};
    taller.size.height = 15.0f;
    ASSERT_TRUE(world.forest().changeTree(tree, taller).empty());
    unloadAndReload(world);
    EXPECT_EQ(world.names().size(), 81u);
    EXPECT_EQ(world.forest().findTree(nearTree), tree)
        << "it belongs to the forest now, and is never unloaded";
    EXPECT_NEAR(world.forest().getPlacement(tree)->size.height, 15.0f, 0.01f);
    EXPECT_EQ(world.forest().getNumTrees(), 81u) << "its tile does not add it again";
}

TEST(TiledEditsTest, EditsAreWrittenAndReadAgain) {
    TiledWorld world;
    Forest& forest = world.forest();
    ASSERT_TRUE(forest.removeTree(*forest.findTree("0/0")).empty());
    TreePlacement moved = *forest.getPlacement(*forest.findTree(nearTree));
    moved.position.x += 5.0;
    ASSERT_TRUE(forest.changeTree(*forest.findTree(nearTree), moved).empty());
    TreePlacement own = moved;
    own.position = {333.0, 333.0, 0.0};
    own.name = "mine";
    ASSERT_TRUE(forest.addTree(own));

    const TemporaryFolder elsewhere;
    for (const std::string& folder : {world.folder().path(), elsewhere.path()}) {
        const std::string file = folder + "/edited.treewind";
        ASSERT_TRUE(writeForestFile(forest.getSimulation().currentDescription(), file).empty());
        Result<ForestFile> edited = readForestFile(file);
        ASSERT_TRUE(edited) << edited.problems().front().text();
        EXPECT_EQ(edited.value().tiles->removed, (std::set<std::string>{"0/0", nearTree}));
        ASSERT_TRUE(loadTiles(edited.value()));
        EXPECT_EQ(edited.value().trees.size(), 900u) << "one removed, one added";
        EXPECT_TRUE(world.forest().setDescription(readForestFile(file).value()).empty());
        EXPECT_FALSE(world.forest().findTree("0/0"));
        EXPECT_TRUE(world.forest().findTree("mine"));
        EXPECT_EQ(world.forest().getPlacement(*world.forest().findTree(nearTree))->position, moved.position);
    }
    std::ifstream written(world.folder().path() + "/edited.treewind");
    const std::string text{std::istreambuf_iterator<char>(written), {}};
    EXPECT_NE(text.find("folder = \"tiles\""), std::string::npos) << "the world can be moved as a whole";
}

TEST(TiledEditsTest, ACopyHasTheEdits) {
    TiledWorld world;
    world.frames(world.at(550.0, 450.0), settleFrames);
    ASSERT_TRUE(world.forest().removeTree(*world.forest().findTree(nearTree)).empty());
    const osg::ref_ptr<Forest> copy = osg::clone(&world.forest(), osg::CopyOp::DEEP_COPY_ALL);
    world.frames(*copy, world.at(550.0, 450.0), settleFrames);
    EXPECT_EQ(TiledWorld::namesOf(*copy).size(), 80u);
}

TEST(TiledEditsTest, AnUnreadableTileGivesAWarningAndNoTree) {
    TiledWorld world;
    std::filesystem::remove(world.tile("5_4"));
    const ScopedMessages messages;
    EXPECT_FALSE(world.forest().findTree(nearTree));
    EXPECT_NE(messages.take().find("5_4.trees"), std::string::npos);
    for (const auto& file : std::filesystem::directory_iterator(world.folder().path() + "/tiles"))
        if (file.path().extension() == ".ids")
            std::filesystem::remove(file.path());
    EXPECT_FALSE(world.forest().findTree("0/0"));
    EXPECT_NE(messages.take().find(".ids"), std::string::npos);
}

TEST(TiledEditsTest, FallenTreesSurviveUnloading) {
    ForestDescription storm;
    storm.species = {*findSpecies("Norway spruce")};
    storm.species[0].wood.bendingStrength *= 20.0f; // roots fail first
    storm.wind = std::make_shared<UniformWind>(glm::vec3(60.0f, 0.0f, 0.0f));
    storm.damage = true;
    TiledWorld world(storm, 20.0f);
    const auto down = [&] {
        std::set<std::string> names;
        for (const TreeId tree : world.forest().getTrees())
            if (!world.forest().getSimulation().isStanding(tree))
                names.insert(world.forest().getSimulation().nameOf(tree));
        return names;
    };
    world.frames(world.at(550.0, 450.0), 400);
    const std::set<std::string> before = down();
    ASSERT_GT(before.size(), 10u);
    EXPECT_TRUE(world.forest().setWind(nullptr).empty());
    unloadAndReload(world);
    EXPECT_EQ(down(), before);
    EXPECT_EQ(world.names().size(), 81u);
    EXPECT_EQ(world.forest().getNumTrees(), 81u);
}
