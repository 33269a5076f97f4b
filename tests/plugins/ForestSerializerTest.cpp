// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <osgTreeWind/wind/FunctionWind.h>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <gtest/gtest.h>

#include <filesystem>

using namespace osgTreeWind;

namespace {

osg::ref_ptr<osg::Node> thereAndBack(const osg::Node& node, const std::string& extension) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/scene." + extension;
    EXPECT_TRUE(osgDB::writeNodeFile(node, file));
    return osgDB::readRefNodeFile(file);
}

osg::ref_ptr<Forest> example(const char* name) {
    return dynamic_cast<Forest*>(osgDB::readRefNodeFile(exampleFile(name)).get());
}

} // namespace

/// The formats of OSG: text, binary, XML.
class ForestSerializerTest : public ::testing::TestWithParam<const char*> {
protected:
    ForestSerializerTest() : _messages(new MessageCollector), _former(osg::getNotifyHandler()) {
        usePluginsOfThisBuild();
        osg::setNotifyHandler(_messages);
    }
    ~ForestSerializerTest() override { osg::setNotifyHandler(_former); }
    std::string takeSaid() { return _messages->take(); }

private:
    osg::ref_ptr<MessageCollector> _messages;
    osg::ref_ptr<osg::NotifyHandler> _former;
};

TEST_P(ForestSerializerTest, bringsBackAForestThatMovesAlike) {
    osg::ref_ptr<Forest> forest = example("forest.treewind");
    ASSERT_TRUE(forest);
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    Forest* const back = dynamic_cast<Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    ASSERT_EQ(back->getNumTrees(), 40u);
    updateFrames(*forest, 1, 10);
    updateFrames(*back, 1, 10);
    EXPECT_EQ(statesOf(*back), statesOf(*forest)) << "shapes, law or wind differ";
    EXPECT_EQ(takeSaid(), "");
}

TEST_P(ForestSerializerTest, findsTheScansOfAForestAgain) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(OSGTREEWIND_TEST_DATA "/scan/treeqsm.txt", folder.path() + "/tree.txt");
    const std::string file =
        folder.write("a.treewind", "version = 1\n[[species]]\nname = \"sapling\"\nscan = \"tree.txt\"\n"
                                   "[[tree]]\nposition = [0, 0]\n");
    osg::ref_ptr<osg::Node> forest = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(dynamic_cast<Forest*>(forest.get()));
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getBound().radius(), forest->getBound().radius());
    EXPECT_EQ(takeSaid(), "");
}

TEST_P(ForestSerializerTest, keepsTheSceneAroundIt) {
    osg::ref_ptr<osg::MatrixTransform> hill = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 30));
    hill->addChild(example("thesis.treewind"));
    hill->addChild(new osg::Group);
    hill->getChild(0)->setName("the tree");
    osg::ref_ptr<osg::Node> node = thereAndBack(*hill, GetParam());
    ASSERT_TRUE(node && node->asGroup());
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    const Forest* const back = dynamic_cast<const Forest*>(node->asGroup()->getChild(0));
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getName(), "the tree");
    EXPECT_EQ(back->getNumTrees(), 1u);
    EXPECT_EQ(takeSaid(), "");
}

TEST_P(ForestSerializerTest, keepsTheUsersChildren) {
    osg::ref_ptr<Forest> forest = example("thesis.treewind");
    osg::ref_ptr<osg::Group> house = new osg::Group;
    house->setName("house");
    forest->addChild(house);
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    ASSERT_TRUE(node && node->asGroup());
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    EXPECT_EQ(node->asGroup()->getChild(1)->getName(), "house");
}

TEST_P(ForestSerializerTest, keepsHowItIsDrawn) {
    osg::ref_ptr<Forest> forest = example("thesis.treewind");
    forest->getBranchwise()->setBranchDrawing(BranchwiseForest::BRANCH_DRAWING);
    forest->getBranchwise()->setLeafDrawing(BranchwiseForest::LEAF_TRANSFORMS);
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getBranchwise()->getBranchDrawing(), BranchwiseForest::BRANCH_DRAWING);
    EXPECT_EQ(back->getBranchwise()->getLeafDrawing(), BranchwiseForest::LEAF_TRANSFORMS);
}

TEST_P(ForestSerializerTest, bringsBackAForestMadeInCodeAsItIsNow) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    const TreeId second = forest->getSimulation().idOf(1);
    TreePlacement moved = forest->getSimulation().placementOf(second);
    moved.position.x += 20.0;
    moved.name = "moved";
    EXPECT_TRUE(forest->changeTree(second, moved).empty());
    EXPECT_TRUE(forest->removeTree(forest->getSimulation().idOf(0)).empty());
    EXPECT_TRUE(forest->addTree(moved));
    forest->setSeason(5.0f); // spring, again
    forest->setWind(std::make_shared<UniformWind>(glm::vec3(3, 4, 0)));
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(takeSaid(), "");
    EXPECT_EQ(back->getNumTrees(), 4u);
    EXPECT_EQ(back->getSeason(), midspring);
    const auto wind = std::dynamic_pointer_cast<const UniformWind>(back->getWind());
    ASSERT_TRUE(wind);
    EXPECT_EQ(wind->velocity(), glm::vec3(3, 4, 0));
    const PlacedTree& tree =
        back->getSimulation().trees()[back->getSimulation().slotOf(*back->getSimulation().findTree("moved"))];
    const PlacedTree& was = forest->getSimulation().trees()[1];
    EXPECT_EQ(tree.position, was.position);
    EXPECT_EQ(tree.scale.axes, was.scale.axes) << "to the bit";
    EXPECT_EQ(tree.scale.radius, was.scale.radius);
}

TEST_P(ForestSerializerTest, leavesOutAWindThatNoFileCanSayAndSaysSo) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    forest->setWind(std::make_shared<FunctionWind>(nullptr));
    osg::ref_ptr<osg::Node> node = thereAndBack(*forest, GetParam());
    EXPECT_NE(takeSaid().find("cannot be written: wind: a wind that no file can say"), std::string::npos);
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getNumTrees(), 2u);
}

TEST_P(ForestSerializerTest, whatNoFileCanSayIsAnEmptyForestAndSaysSo) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    ForestDescription description = smallForest(2);
    description.species[0].name = "\xe9";
    scene->addChild(new Forest(description));
    osg::ref_ptr<osg::Node> node = thereAndBack(*scene, GetParam());
    EXPECT_NE(takeSaid().find("cannot be written: species[0].name: expected UTF-8"), std::string::npos);
    ASSERT_TRUE(node && node->asGroup()) << "the rest of the scene is still good";
    EXPECT_EQ(node->asGroup()->getNumChildren(), 1u);
}

TEST_P(ForestSerializerTest, isSmall) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/forest." + GetParam();
    osgDB::writeNodeFile(*example("forest.treewind"), file);
    EXPECT_LT(std::filesystem::file_size(file), 20000u) << "the document, not its geometry";
}

INSTANTIATE_TEST_SUITE_P(Formats, ForestSerializerTest, ::testing::Values("osgt", "osgb", "osgx"),
                         [](const auto& info) { return std::string(info.param); });
