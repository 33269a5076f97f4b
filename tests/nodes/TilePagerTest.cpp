// SPDX-License-Identifier: MIT
// A forest in tiles below a viewer's pager, without a context.
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/nodes/TilePager.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/FileServer.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgDB/DatabasePager>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <set>
#include <thread>

using namespace osgTreeWind;

namespace {

/// What a cull traversal tells of where it looks from.
class Eye : public osg::NodeVisitor {
public:
    explicit Eye(const osg::Vec3& place)
        : osg::NodeVisitor(CULL_VISITOR, TRAVERSE_ACTIVE_CHILDREN), _place(place) {}
    osg::Vec3 getEyePoint() const override { return _place; }
    osg::Vec3 getViewPoint() const override { return _place; }

private:
    osg::Vec3 _place;
};

/// 10 x 10 tiles of 100 m with nine trees each, at 100 m's range.
class World {
public:
    World() {
        ForestDescription forest = smallForest(0);
        for (int x = 0; x < 30; ++x)
            for (int y = 0; y < 30; ++y) {
                TreePlacement tree;
                tree.position = {100.0 / 3.0 * (x + 0.5), 100.0 / 3.0 * (y + 0.5), 0.0};
                tree.size.height = 4.0f + 0.1f * static_cast<float>(x);
                tree.seed = static_cast<std::uint32_t>(30 * x + y);
                tree.name = std::to_string(x) + '/' + std::to_string(y);
                forest.trees.push_back(tree);
            }
        TilingOptions options;
        options.size = 100.0;
        options.range = 100.0;
        EXPECT_TRUE(writeTiledForest(forest, _folder.path(), options));
        Result<ForestDescription> world = readForestFile(_folder.path() + "/world.treewind");
        EXPECT_TRUE(world);
        _forest = new Forest(std::move(world.value()));
        _pager->setTargetMaximumNumberOfPageLOD(0);
    }
    ~World() { _pager->cancel(); }

    Forest& forest() { return *_forest; }
    /// Its tiles come from there from now on.
    void readFrom(const std::string& url) {
        Result<ForestDescription> world = readForestFile(_folder.path() + "/world.treewind");
        world.value().tiles->folder = url;
        _forest->setDescription(std::move(world.value()));
    }
    const TemporaryFolder& folder() const { return _folder; }
    std::string tile(const std::string& name) const { return _folder.path() + "/tiles/" + name + ".trees"; }

    /// Frames of 0.1 s, with the time that a pager's thread takes.
    void frames(const osg::Vec3& eye, int count) { frames(*_forest, eye, count); }
    void frames(Forest& forest, const osg::Vec3& eye, int count) {
        for (int i = 0; i < count; ++i) {
            osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
            stamp->setFrameNumber(++_frame);
            stamp->setSimulationTime(0.1 * _frame);
            stamp->setReferenceTime(0.1 * _frame);
            _pager->signalBeginFrame(stamp);
            _pager->updateSceneGraph(*stamp);
            osgUtil::UpdateVisitor update;
            update.setFrameStamp(stamp);
            forest.accept(update);
            Eye cull(eye);
            cull.setFrameStamp(stamp);
            cull.setDatabaseRequestHandler(_pager);
            forest.accept(cull);
            _pager->signalEndFrame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    std::set<std::string> names() const { return namesOf(*_forest); }
    static std::set<std::string> namesOf(const Forest& forest) {
        std::set<std::string> names;
        for (const TreeId tree : forest.getTrees())
            names.insert(forest.getPlacement(tree)->name);
        return names;
    }

private:
    TemporaryFolder _folder;
    osg::ref_ptr<osgDB::DatabasePager> _pager = osgDB::DatabasePager::create();
    osg::ref_ptr<Forest> _forest;
    unsigned _frame = 0;
};

constexpr int enough = 100; // frames: for what is near to come, for what is far to go

/// The forest's frame is the world's but for its origin.
osg::Vec3 at(World& world, double x, double y) {
    return osg::Vec3d(x, y, 2.0) - world.forest().getOrigin();
}

} // namespace

TEST(TilePagerTest, treesInRangeComeAndThoseBeyondDoNot) {
    World world;
    EXPECT_EQ(world.forest().getNumTrees(), 0u);
    world.frames(at(world, 550.0, 450.0), enough);
    const std::set<std::string> names = world.names();
    // A tile in the middle of which one stands is 50 m away on all sides: its eight neighbours are in range.
    EXPECT_EQ(names.size(), 81u);
    EXPECT_TRUE(names.count("15/12"));
    EXPECT_TRUE(names.count("20/16"));
    EXPECT_FALSE(names.count("21/12"));
}

TEST(TilePagerTest, theyGoAndComeBackTheSame) {
    World world;
    world.frames(at(world, 50.0, 50.0), enough);
    const std::optional<TreePlacement> before = world.forest().getPlacement(world.forest().findTree("2/1"));
    ASSERT_TRUE(before);
    world.frames(at(world, 950.0, 950.0), enough);
    EXPECT_EQ(world.forest().findTree("2/1"), noTree);
    EXPECT_NE(world.forest().findTree("29/29"), noTree);
    world.frames(at(world, 50.0, 50.0), enough);
    const std::optional<TreePlacement> after = world.forest().getPlacement(world.forest().findTree("2/1"));
    ASSERT_TRUE(after);
    EXPECT_EQ(after->position, before->position);
    EXPECT_EQ(after->seed, before->seed);
    EXPECT_EQ(after->size.height, before->size.height);
    EXPECT_EQ(world.forest().findTree("29/29"), noTree);
}

TEST(TilePagerTest, aShortWayBackCostsNothing) {
    World world;
    world.frames(at(world, 550.0, 450.0), enough);
    const TreeId tree = world.forest().findTree("15/12");
    world.frames(at(world, 950.0, 450.0), 20);
    world.frames(at(world, 550.0, 450.0), 20);
    EXPECT_EQ(world.forest().findTree("15/12"), tree) << "it is the same one still";
}

TEST(TilePagerTest, aMissingTileLeavesAHoleAndHeals) {
    World world;
    const std::string file = world.tile("5_4"), aside = world.folder().path() + "/aside";
    std::filesystem::rename(file, aside);
    osg::ref_ptr<MessageCollector> messages = new MessageCollector;
    osg::setNotifyHandler(messages);
    world.frames(at(world, 550.0, 450.0), enough);
    osg::setNotifyHandler(new osg::StandardNotifyHandler);
    EXPECT_EQ(world.names().size(), 72u);
    const std::string said = messages->take();
    EXPECT_NE(said.find("5_4.trees"), std::string::npos) << said;
    EXPECT_LE(std::count(said.begin(), said.end(), '\n'), 4) << "not in each frame:\n" << said;
    std::filesystem::rename(aside, file);
    world.frames(at(world, 550.0, 450.0), 200);
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, aCutOffTileLeavesAHoleAndHeals) {
    World world;
    const std::string file = world.tile("5_4");
    std::ostringstream whole;
    whole << std::ifstream(file).rdbuf();
    const std::string text = whole.str();
    osg::ref_ptr<MessageCollector> messages = new MessageCollector;
    osg::setNotifyHandler(messages);
    // In the middle of a row, and between two.
    for (const std::size_t size : {text.size() - 7, text.rfind('\n', text.size() - 2) + 1}) {
        std::ofstream(file) << text.substr(0, size);
        world.frames(at(world, 550.0, 450.0), enough);
        EXPECT_EQ(world.names().size(), 72u);
        EXPECT_NE(messages->take().find("5_4.trees"), std::string::npos);
        world.frames(at(world, 50.0, 50.0), enough);
    }
    osg::setNotifyHandler(new osg::StandardNotifyHandler);
    std::ofstream(file) << text;
    world.frames(at(world, 550.0, 450.0), 200);
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, aCopyBringsItsOwn) {
    World world;
    world.frames(at(world, 550.0, 450.0), enough);
    const osg::ref_ptr<Forest> copy = osg::clone(&world.forest(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(copy->getNumTrees(), 0u);
    world.frames(*copy, at(world, 50.0, 50.0), enough);
    EXPECT_EQ(World::namesOf(*copy).size(), 36u) << "a corner, and its three neighbours";
    EXPECT_EQ(world.names().size(), 81u);
}

TEST(TilePagerTest, treesOfTheHostStay) {
    World world;
    TreePlacement own;
    own.position = {550.0, 450.0, 0.0};
    own.name = "mine";
    ASSERT_TRUE(world.forest().addTree(own));
    world.frames(at(world, 550.0, 450.0), enough);
    world.frames(at(world, 950.0, 950.0), enough);
    EXPECT_NE(world.forest().findTree("mine"), noTree);
    const ForestDescription now = world.forest().getSimulation().describe();
    ASSERT_EQ(now.trees.size(), 1u) << "those of tiles are said by their tiles";
    EXPECT_TRUE(now.tiles);
}

TEST(TilePagerTest, aTreeThatComesSwaysAsIfItHadBeenThere) {
    World world;
    std::istringstream text("version = 1\n[wind]\nkind = \"gusts\"\nspeed = 9.0\ndirection_from = 250.0\n"
                            "[[tree]]\nposition = [0.0, 0.0]\n");
    const WindFieldPtr gusts = readForest(text).value().wind;
    world.forest().setWind(gusts, WindFrame::Forest);
    world.frames(at(world, 950.0, 950.0), 500);
    world.frames(at(world, 250.0, 250.0), 5);

    Result<ForestDescription> all = readForestFile(world.folder().path() + "/world.treewind");
    ASSERT_TRUE(loadTiles(all.value()).empty());
    all.value().wind = gusts;
    SimulationOptions far;
    far.level = ModalLevel::Far;
    ForestSimulation whole(all.value(), far);
    for (int frame = 1; frame <= 505; ++frame)
        whole.advance(0.1 * frame);
    double difference = 0.0, sway = 0.0;
    for (const TreeId tree : world.forest().getTrees()) {
        const std::string name = world.forest().getSimulation().nameOf(tree);
        const ForestSimulation& here = world.forest().getSimulation();
        const glm::vec2 lean = here.modal()->lean(here.slotOf(tree)),
                        expected = whole.modal()->lean(whole.slotOf(*whole.findTree(name)));
        difference += static_cast<double>(glm::dot(lean - expected, lean - expected));
        sway += static_cast<double>(glm::dot(expected, expected));
    }
    ASSERT_GT(sway, 0.0);
    EXPECT_LT(std::sqrt(difference / sway), 0.05);
}

TEST(TilePagerTest, aServerIsAsGoodAsAFolder) {
    World world;
    const FileServer server(world.folder().path());
    world.readFrom(server.url() + "/tiles");
    world.frames(at(world, 550.0, 450.0), enough);
    EXPECT_EQ(world.names().size(), 81u);
    EXPECT_NE(world.forest().findTree("15/12"), noTree);
}

TEST(TilePagerTest, aServerThatFailsNowAndThenIsAskedAgain) {
    World world;
    FileServer server(world.folder().path());
    server.failOneIn(4);
    world.readFrom(server.url() + "/tiles");
    osg::ref_ptr<MessageCollector> messages = new MessageCollector;
    osg::setNotifyHandler(messages);
    world.frames(at(world, 550.0, 450.0), 10);
    world.frames(at(world, 250.0, 250.0), enough);
    world.frames(at(world, 550.0, 450.0), 400);
    osg::setNotifyHandler(new osg::StandardNotifyHandler);
    EXPECT_GE(server.failures(), 3) << "each way of failing once";
    EXPECT_EQ(world.names().size(), 81u) << messages->take();
}
