// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/TreeUnit.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osg/AnimationPath>
#include <osg/ShapeDrawable>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace osgTreeWind;

namespace {

osg::ref_ptr<osg::Node> writeAndRead(const osg::Node& node, const std::string& extension) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/scene." + extension;
    EXPECT_TRUE(osgDB::writeNodeFile(node, file));
    return osgDB::readRefNodeFile(file);
}

osg::ref_ptr<Forest> example(const char* name) {
    return dynamic_cast<Forest*>(osgDB::readRefNodeFile(exampleFile(name)).get());
}

} // namespace

/// By the extension of OSG's text, binary and XML format.
class ForestSerializerTest : public ::testing::TestWithParam<const char*> {
protected:
    ForestSerializerTest() { usePluginsOfThisBuild(); }
    std::string takeWarnings() { return _messages.take(); }

private:
    const ScopedMessages _messages;
};

TEST_P(ForestSerializerTest, ARestoredForestMovesTheSame) {
    osg::ref_ptr<Forest> forest = example("forest.treewind");
    ASSERT_TRUE(forest);
    osg::ref_ptr<osg::Node> node = writeAndRead(*forest, GetParam());
    Forest* const back = dynamic_cast<Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    ASSERT_EQ(back->getNumTrees(), 40u);
    updateFrames(*forest, 1, 10);
    updateFrames(*back, 1, 10);
    EXPECT_EQ(statesOf(*back), statesOf(*forest)) << "shapes, law or wind differ";
    EXPECT_EQ(takeWarnings(), "");
}

TEST_P(ForestSerializerTest, ARestoredForestFindsItsScans) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(OSGTREEWIND_TEST_DATA "/scan/treeqsm.txt", folder.path() + "/tree.txt");
    const std::string file =
        folder.write("a.treewind", "version = 1\n[[species]]\nname = \"sapling\"\nscan = \"tree.txt\"\n"
                                   "[[tree]]\nposition = [0, 0]\n");
    osg::ref_ptr<osg::Node> forest = osgDB::readRefNodeFile(file);
    ASSERT_TRUE(dynamic_cast<Forest*>(forest.get()));
    osg::ref_ptr<osg::Node> node = writeAndRead(*forest, GetParam());
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getBound().radius(), forest->getBound().radius());
    EXPECT_EQ(takeWarnings(), "");
}

TEST_P(ForestSerializerTest, KeepsTheSceneAroundTheForest) {
    osg::ref_ptr<osg::MatrixTransform> hill = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 30));
    hill->addChild(example("thesis.treewind"));
    hill->addChild(new osg::Group);
    hill->getChild(0)->setName("the tree");
    osg::ref_ptr<osg::Node> node = writeAndRead(*hill, GetParam());
    ASSERT_TRUE(node && node->asGroup());
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    const Forest* const back = dynamic_cast<const Forest*>(node->asGroup()->getChild(0));
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getName(), "the tree");
    EXPECT_EQ(back->getNumTrees(), 1u);
    EXPECT_EQ(takeWarnings(), "");
}

TEST_P(ForestSerializerTest, ASceneWithGroundSourcesAndAVehicleMovesTheSame) {
    const TemporaryFolder folder;
    std::string slope = "ncols 5\nnrows 5\nxllcorner -50\nyllcorner -50\ncellsize 25\n";
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            slope += std::to_string(2 * row + column) + (column < 4 ? " " : "\n");
    folder.write("slope.asc", slope);
    const std::string file = folder.write(
        "scene.treewind", "version = 1\n[ground]\nfile = \"slope.asc\"\n[wind]\nkind = \"gusts\"\nspeed = "
                          "8.0\ndirection_from = 250.0\n"
                          "[[wind.source]]\nkind = \"rotor\"\nposition = [0.0, 0.0, 40.0]\n"
                          "[[wind.source]]\nkind = \"vehicle\"\nposition = [-20.0, 6.0, 0.0]\n"
                          "velocity = [15.0, 0.0, 0.0]\n[scatter]\ncount = 12\narea = [-20, -20, 20, 20]\n"
                          "species = [\"silver birch\", \"Norway spruce\"]\n");
    osg::ref_ptr<osg::AnimationPath> path = new osg::AnimationPath;
    path->insert(0.0, {osg::Vec3d(-20.0, 6.0, 0.0)});
    path->insert(10.0, {osg::Vec3d(130.0, 6.0, 0.0)});
    osg::ref_ptr<osg::MatrixTransform> lorry = new osg::MatrixTransform;
    lorry->addChild(new osg::ShapeDrawable(new osg::Box({6.0f, 0.0f, 2.0f}, 12.0f, 2.5f, 4.0f)));
    lorry->setUpdateCallback(new osg::AnimationPathCallback(path));
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(lorry);
    scene->addChild(osgDB::readRefNodeFile(file));

    osg::ref_ptr<osg::Node> back = writeAndRead(*scene, GetParam());
    ASSERT_TRUE(back && back->asGroup()->getNumChildren() == 2u) << takeWarnings();
    updateFrames(*scene, 1, 75);
    updateFrames(*back, 1, 75);
    auto* one = dynamic_cast<Forest*>(scene->getChild(1));
    auto* other = dynamic_cast<Forest*>(back->asGroup()->getChild(1));
    ASSERT_TRUE(one && other);
    ASSERT_EQ(other->getTrees().size(), 12u);
    float most = 0.0f;
    for (std::size_t i = 0; i < 12; ++i) {
        const std::vector<TreeUnit> units = one->getUnits(one->getTrees()[i]),
                                    others = other->getUnits(other->getTrees()[i]);
        ASSERT_EQ(units.size(), others.size());
        for (std::size_t unit = 0; unit < units.size(); ++unit) {
            most = std::max(most, (units[unit].tip - others[unit].tip).length());
        }
    }
    EXPECT_LT(most, 1e-4f) << "metres";
    const auto matrix = [](osg::Node* node) { return node->asTransform()->asMatrixTransform()->getMatrix(); };
    EXPECT_EQ(matrix(back->asGroup()->getChild(0)), matrix(lorry));
    EXPECT_EQ(takeWarnings(), "");
}

TEST_P(ForestSerializerTest, KeepsTheHostsChildren) {
    osg::ref_ptr<Forest> forest = example("thesis.treewind");
    osg::ref_ptr<osg::Group> house = new osg::Group;
    house->setName("house");
    forest->addChild(house);
    osg::ref_ptr<osg::Node> node = writeAndRead(*forest, GetParam());
    ASSERT_TRUE(node && node->asGroup());
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    EXPECT_EQ(node->asGroup()->getChild(1)->getName(), "house");
}

TEST_P(ForestSerializerTest, RestoresAForestMadeInCode) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    const TreeId second = TreeId(1);
    TreePlacement moved = *forest->getSimulation().placementOf(second);
    moved.position.x += 20.0;
    moved.name = "moved";
    EXPECT_TRUE(forest->changeTree(second, moved).empty());
    EXPECT_TRUE(forest->removeTree(TreeId(0)).empty());
    EXPECT_TRUE(forest->addTree(moved));
    EXPECT_TRUE(forest->setSeason(5.0f).empty()); // spring, again
    EXPECT_TRUE(forest->setWind(std::make_shared<UniformWind>(glm::vec3(3, 4, 0))).empty());
    osg::ref_ptr<osg::Node> node = writeAndRead(*forest, GetParam());
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(takeWarnings(), "");
    EXPECT_EQ(back->getNumTrees(), 4u);
    EXPECT_EQ(back->getSeason(), midspring);
    const auto wind = std::dynamic_pointer_cast<const UniformWind>(back->getWind().field);
    ASSERT_TRUE(wind);
    EXPECT_EQ(wind->velocity(), glm::vec3(3, 4, 0));
    const PlacedTree& tree =
        movingForest(back->getSimulation()).trees()[slotOfTree(*back->getSimulation().findTree("moved"))];
    const PlacedTree& was = movingForest(forest->getSimulation()).trees()[1];
    EXPECT_EQ(tree.position, was.position);
    EXPECT_EQ(tree.scale.axes, was.scale.axes) << "exactly";
    EXPECT_EQ(tree.scale.radius, was.scale.radius);
}

TEST_P(ForestSerializerTest, OmitsAWindWithoutFileFormWithAWarning) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    EXPECT_TRUE(forest->setWind(std::make_shared<FunctionWind>(nullptr)).empty());
    osg::ref_ptr<osg::Node> node = writeAndRead(*forest, GetParam());
    EXPECT_NE(takeWarnings().find("is written without its wind: wind: this wind cannot be written to a file"),
              std::string::npos);
    const Forest* const back = dynamic_cast<const Forest*>(node.get());
    ASSERT_NE(back, nullptr);
    EXPECT_EQ(back->getNumTrees(), 2u);
}

TEST_P(ForestSerializerTest, RefusesAForestWithoutADocument) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    const TemporaryFolder folder;
    ForestDescription description = smallForest(2);
    description.species[0].appearance.barkImage = folder.path() + "/bark.png";
    scene->addChild(new Forest(description));
    const std::string file = folder.path() + "/scene." + GetParam();
    EXPECT_FALSE(osgDB::writeNodeFile(*scene, file));
    EXPECT_NE(takeWarnings().find("a Forest cannot be written: species[0].appearance: no file "),
              std::string::npos);
    const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(file);
    const std::string warnings = takeWarnings();
    EXPECT_TRUE(!back || warnings.find("version") != std::string::npos) << warnings;
}

TEST_P(ForestSerializerTest, IsSmall) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/forest." + GetParam();
    osgDB::writeNodeFile(*example("forest.treewind"), file);
    EXPECT_LT(std::filesystem::file_size(file), 20000u) << "the document without geometry";
}

INSTANTIATE_TEST_SUITE_P(Formats, ForestSerializerTest, ::testing::Values("osgt", "osgb", "osgx"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ForestTextTest, ReadsTheRemovedDrawingModes) {
    usePluginsOfThisBuild();
    std::ostringstream written;
    written << std::ifstream(OSGTREEWIND_TEST_DATA "/written-by-1.0/thesis.osgt").rdbuf();
    for (const std::string ways : {"0 0", "0 1", "1 0"}) { // removed modes
        std::string text = written.str();
        const std::string now = "BranchwiseDrawing 1 1";
        ASSERT_NE(text.find(now), std::string::npos);
        text.replace(text.find(now), now.size(), "BranchwiseDrawing " + ways);
        const TemporaryFolder folder;
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(folder.write("a.osgt", text));
        const auto* forest = dynamic_cast<const Forest*>(node.get());
        ASSERT_NE(forest, nullptr) << ways;
        EXPECT_EQ(forest->getNumTrees(), 1u) << ways;
        EXPECT_NE(forest->getBranchwise(), nullptr) << ways;
    }
}
