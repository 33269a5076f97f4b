// SPDX-License-Identifier: MIT
// Scenes and a tiled forest written by version 1.0, which every version must read
// (tests/data/written-by-1.0/README.md).
#include <tests/Folders.h>
#include <tests/MessageCollector.h>
#include <tests/plugins/PluginPath.h>

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osgDB/ReadFile>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

using namespace osgTreeWind;

/// Expects no messages except those on the growth parameters of version 1.
class WrittenBy1 : public ::testing::Test {
protected:
    WrittenBy1() { usePluginsOfThisBuild(); }
    ~WrittenBy1() override {
        std::istringstream messages(_messages.take());
        for (std::string line; std::getline(messages, line);)
            EXPECT_NE(line.find("[species.growth] of version 1 is read as"), std::string::npos) << line;
    }

    static osg::ref_ptr<Forest> readVersion1Forest(const std::string& name) {
        const osg::ref_ptr<osg::Node> node =
            osgDB::readRefNodeFile(OSGTREEWIND_TEST_DATA "/written-by-1.0/" + name);
        return dynamic_cast<Forest*>(node.get());
    }

private:
    const ScopedMessages _messages;
};

TEST_F(WrittenBy1, ReadsScenesOfAForest) {
    for (const char* name : {"forest.osgt", "forest.osgb"}) {
        const osg::ref_ptr<Forest> forest = readVersion1Forest(name);
        ASSERT_TRUE(forest) << name;
        EXPECT_EQ(forest->getName(), "forest.treewind");
        EXPECT_EQ(forest->getNumTrees(), 40u);
        EXPECT_EQ(forest->getDescription().species.size(), 3u);
        EXPECT_EQ(asField(forest->getWind())->velocity(WindPlace(0.0f, 0.0f, 10.0f), 15.0),
                  glm::vec3(9.0f, 3.5f, 0.0f));
    }
}

TEST_F(WrittenBy1, ReadsScenesOfTheThesis) {
    for (const char* name : {"thesis.osgt", "thesis.osgb"}) {
        const osg::ref_ptr<Forest> forest = readVersion1Forest(name);
        ASSERT_TRUE(forest) << name;
        EXPECT_EQ(forest->getNumTrees(), 1u);
        EXPECT_EQ(forest->getDescription().law, MotionLaw::Thesis);
        EXPECT_NE(forest->getBranchwise(), nullptr);
        EXPECT_TRUE(forest->branch(TreeId(0), 121));
        EXPECT_FALSE(forest->branch(TreeId(0), 122));
    }
}

TEST_F(WrittenBy1, FindsTreesOfTilesByTheirIds) {
    const osg::ref_ptr<Forest> world = readVersion1Forest("world/world.treewind");
    ASSERT_TRUE(world);
    EXPECT_EQ(world->getNumTrees(), 0u);
    EXPECT_TRUE(world->findTree("7"));
    EXPECT_EQ(world->getNumTrees(), 5u) << "all of tile 1_0";
    EXPECT_TRUE(world->findTree("1_1/3"));
    EXPECT_EQ(world->getNumTrees(), 9u);
}
