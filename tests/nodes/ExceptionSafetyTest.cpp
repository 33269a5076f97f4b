// SPDX-License-Identifier: MIT
// Callbacks of the host throw, or files cannot be read: no exception reaches OSG or the host.
#include <osgTreeWind/nodes/TileReader.h>
#include <osgTreeWind/places/FunctionGround.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/Culling.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/TiledWorld.h>
#include <tests/plugins/PluginPath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>

using namespace osgTreeWind;

namespace {

class ExceptionSafetyTest : public testing::Test {
protected:
    std::string takeMessages() { return _messages.take(); }
    static auto lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

private:
    const ScopedMessages _messages;
};

template <typename Exception>
FunctionWind::Function failingAfter(double time, const Exception& exception) {
    return [=](const glm::vec3&, double now) -> glm::vec3 {
        if (now > time)
            throw exception;
        return {10.0f, 0.0f, 0.0f};
    };
}

} // namespace

TEST_F(ExceptionSafetyTest, AFolderInPlaceOfAFileIsAProblemWithItsPath) {
    usePluginsOfThisBuild();
    registerTileReader();
    const TemporaryFolder folder;
    for (const char* extension : {"trees", "ids", "crowns", "treewind"}) {
        const std::string path = folder.path() + "/a." + extension;
        std::filesystem::create_directory(path);
        const osgDB::ReaderWriter* reader =
            osgDB::Registry::instance()->getReaderWriterForExtension(extension);
        ASSERT_NE(reader, nullptr) << extension;
        const osgDB::ReaderWriter::ReadResult result = reader->readNode(path, nullptr);
        EXPECT_TRUE(result.error()) << extension;
        EXPECT_NE(result.message().find("a." + std::string(extension) + ": not a regular file"),
                  std::string::npos)
            << result.message();
    }
}

TEST_F(ExceptionSafetyTest, AFolderInPlaceOfATileIsRetried) {
    TiledWorld world;
    const std::string file = world.tile("5_4"), aside = world.folder().path() + "/aside";
    std::filesystem::rename(file, aside);
    std::filesystem::create_directory(file);
    world.frames(world.at(550.0, 450.0), settleFrames);
    EXPECT_EQ(world.names().size(), 72u);
    EXPECT_NE(takeMessages().find("5_4.trees"), std::string::npos);
    std::filesystem::remove(file);
    std::filesystem::rename(aside, file);
    world.frames(world.at(550.0, 450.0), 200);
    EXPECT_EQ(world.names().size(), 81u);
}

TEST_F(ExceptionSafetyTest, AWindThatThrowsStopsTheForest) {
    for (const auto& wind :
         {failingAfter(1.0, std::runtime_error("no wind there")), failingAfter(1.0, std::bad_alloc())})
        for (const MotionLaw law : {MotionLaw::Modal, MotionLaw::ThesisSmooth}) {
            ForestDescription description = smallForest(4);
            description.law = law;
            description.wind = std::make_shared<FunctionWind>(wind);
            osg::ref_ptr<Forest> forest = new Forest(description);
            updateFrames(*forest, 1, 40);
            const std::vector<glm::vec4> still = statesOf(*forest);
            EXPECT_NE(still.front(), glm::vec4(0.0f));
            updateFrames(*forest, 41, 80);
            EXPECT_EQ(statesOf(*forest), still);
            cull(*forest, 81, osg::Vec3d(5, -30, 5));
            const std::string text = takeMessages();
            EXPECT_EQ(lines(text), 1) << "one warning, not one per frame:\n" << text;
            EXPECT_NE(text.find("stands still"), std::string::npos) << text;
            EXPECT_TRUE(forest->setDescription(smallForest(4)).empty());
            updateFrames(*forest, 82, 90);
            EXPECT_NE(statesOf(*forest).front(), glm::vec4(0.0f)) << "it moves again";
            EXPECT_EQ(takeMessages(), "");
        }
}

TEST_F(ExceptionSafetyTest, HostThreadsReceiveNoException) {
    std::atomic<int> met{0};
    bool fails = false;
    const Executor host = [&](std::size_t count, const std::function<void(std::size_t)>& job) {
        if (fails)
            throw std::runtime_error("no threads");
        for (std::size_t i = 0; i < count; ++i)
            met += !runGuarded([&] { job(i); }).empty();
    };
    ForestDescription description = smallForest(4);
    description.wind = std::make_shared<FunctionWind>(failingAfter(1.0, std::runtime_error("no wind")));
    osg::ref_ptr<Forest> forest = Forest::create(description, host).value();
    updateFrames(*forest, 1, 40);
    EXPECT_EQ(met, 0);
    EXPECT_NE(takeMessages().find("no wind; the forest stands still"), std::string::npos);
    EXPECT_TRUE(forest->setDescription(smallForest(4)).empty());
    fails = true;
    updateFrames(*forest, 41, 50);
    EXPECT_NE(takeMessages().find("no threads; the forest stands still"), std::string::npos);
}

TEST_F(ExceptionSafetyTest, AGroundThatThrowsLeavesTheForestEmpty) {
    ForestDescription description = smallForest(4);
    description.ground = std::make_shared<FunctionGround>(
        [](double, double) -> double { throw std::runtime_error("no ground"); });
    const Result<osg::ref_ptr<Forest>> forest = Forest::create(description);
    ASSERT_FALSE(forest);
    EXPECT_EQ(forest.problems().front().message, "no ground");
    osg::ref_ptr<Forest> given = new Forest(description);
    EXPECT_EQ(given->getNumTrees(), 0u);
    EXPECT_NE(takeMessages().find("the forest is left empty: no ground"), std::string::npos);
}

TEST_F(ExceptionSafetyTest, AnExceptionOfADamageCallbackDoesNotReachTheViewer) {
    ForestDescription description = smallForest(1, 20.0f);
    description.species[0].wood.anchorage = 0.05f;
    description.trees[0].size.height = 10.0f;
    description.damage = true;
    osg::ref_ptr<Forest> forest = new Forest(description);
    forest->setDamageCallback([](const TreeDamage&) { throw std::runtime_error("not mine"); });
    updateFrames(*forest, 1, 1000);
    EXPECT_NE(takeMessages().find("not mine; the forest stands still"), std::string::npos);
}
