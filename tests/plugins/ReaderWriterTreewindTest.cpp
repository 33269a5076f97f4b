// SPDX-License-Identifier: MIT
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <gtest/gtest.h>

#include <sstream>
#include <thread>
#include <typeinfo>

using namespace osgTreeWind;

namespace {

/// Collects OSG's messages from level NOTICE on during a test.
class ReaderWriterTreewindTest : public ::testing::Test {
protected:
    ReaderWriterTreewindTest() { usePluginsOfThisBuild(); }

    const std::string& messages() { return _text += _messages.take(); }
    static osgDB::ReaderWriter* plugin() {
        return osgDB::Registry::instance()->getReaderWriterForExtension("treewind");
    }

private:
    const ScopedMessages _messages;
    std::string _text;
};

osg::ref_ptr<Forest> readForestNode(const std::string& file) {
    return dynamic_cast<Forest*>(osgDB::readRefNodeFile(file).get());
}

constexpr const char* oneTreeDocument = "version = 1\n[[tree]]\nposition = [1.0, 2.0]\n";

} // namespace

TEST_F(ReaderWriterTreewindTest, ReadsTheReferenceTree) {
    osg::ref_ptr<Forest> forest = readForestNode(exampleFile("thesis.treewind"));
    ASSERT_TRUE(forest);
    const Forest& read = *forest;
    EXPECT_TRUE(&typeid(read) == &typeid(Forest)) << "the plugin has a second Forest class";
    EXPECT_EQ(forest->getNumTrees(), 1u);
    EXPECT_EQ(forest->getName(), "thesis.treewind") << "for messages";
    EXPECT_EQ(branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getNumBranches(), 122u);
    EXPECT_EQ(messages(), "");
}

TEST_F(ReaderWriterTreewindTest, ReadsTheScatteredForestWithItsWind) {
    osg::ref_ptr<Forest> forest = readForestNode(exampleFile("forest.treewind"));
    ASSERT_TRUE(forest);
    EXPECT_EQ(forest->getNumTrees(), 40u);
    ASSERT_FALSE(forest->getWind().isCalm());
    EXPECT_GT(asField(forest->getWind())->velocity({0, 0, 10}, 0.0).x, 1.0f);
    EXPECT_EQ(messages(), "");
}

TEST_F(ReaderWriterTreewindTest, ReadObjectReturnsTheForest) { // as osgconv calls it
    osg::ref_ptr<osg::Object> object = osgDB::readRefObjectFile(exampleFile("thesis.treewind"));
    EXPECT_NE(dynamic_cast<Forest*>(object.get()), nullptr);
}

TEST_F(ReaderWriterTreewindTest, OptionsOverrideKeysOfTheFile) {
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("noRotation treewind.season=winter treewind.wind.height=20");
    osg::ref_ptr<Forest> forest =
        dynamic_cast<Forest*>(osgDB::readRefNodeFile(exampleFile("forest.treewind"), options).get());
    ASSERT_TRUE(forest);
    EXPECT_EQ(forest->getSeason(), midwinter);
    EXPECT_EQ(messages(), "");
    options->setOptionString("treewind.wind.heigt=20");
    EXPECT_FALSE(osgDB::readRefNodeFile(exampleFile("forest.treewind"), options));
    EXPECT_NE(messages().find("did you mean height"), std::string::npos) << messages();
}

TEST_F(ReaderWriterTreewindTest, ABrokenFileGivesAnErrorWithItsPlace) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "broken.treewind", "version = 1\n[wind]\n  kind = \"gale\"\n[[tree]]\nposition = [0, 0]\n");
    EXPECT_FALSE(osgDB::readRefNodeFile(file));
    EXPECT_NE(messages().find(file + ":3:"), std::string::npos) << messages();
    EXPECT_EQ(std::count(messages().begin(), messages().end(), '\n'), 1) << "one line: " << messages();
}

TEST_F(ReaderWriterTreewindTest, RejectsRandomBytes) {
    const TemporaryFolder folder;
    std::string noise;
    std::mt19937 random(3);
    for (int i = 0; i < 5000; ++i)
        noise += static_cast<char>(random());
    EXPECT_FALSE(osgDB::readRefNodeFile(folder.write("noise.treewind", noise)));
    EXPECT_NE(messages().find("noise.treewind:"), std::string::npos) << messages();
}

TEST_F(ReaderWriterTreewindTest, DistinguishesMissingFilesFromOtherFormats) {
    ASSERT_TRUE(plugin());
    EXPECT_EQ(plugin()->readNode(std::string("nowhere.treewind"), nullptr).status(),
              osgDB::ReaderWriter::ReadResult::FILE_NOT_FOUND);
    EXPECT_EQ(plugin()->readNode(std::string("cow.osg"), nullptr).status(),
              osgDB::ReaderWriter::ReadResult::FILE_NOT_HANDLED);
    const TemporaryFolder folder;
    EXPECT_EQ(plugin()->readNode(folder.write("a.treewind", "version = 0"), nullptr).status(),
              osgDB::ReaderWriter::ReadResult::ERROR_IN_READING_FILE);
}

TEST_F(ReaderWriterTreewindTest, AStreamFindsItsFilesInTheDatabasePath) {
    const TemporaryFolder folder;
    folder.write("trees.csv", "x,y\n1,2\n3,4\n5,6\n");
    const std::string document = "version = 1\n[[species]]\nname = \"oak\"\n"
                                 "[inventory]\nfile = \"trees.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setDatabasePath(folder.path());
    std::istringstream stream(document);
    osgDB::ReaderWriter::ReadResult read = plugin()->readNode(stream, options);
    ASSERT_TRUE(read.validNode()) << read.statusMessage();
    EXPECT_EQ(dynamic_cast<Forest&>(*read.getNode()).getNumTrees(), 3u);
}

TEST_F(ReaderWriterTreewindTest, AStreamNeedsNoOptions) {
    std::istringstream stream(oneTreeDocument);
    osgDB::ReaderWriter::ReadResult read = plugin()->readObject(stream, nullptr);
    ASSERT_TRUE(read.validObject()) << read.statusMessage();
}

TEST_F(ReaderWriterTreewindTest, FindsFilesInTheDatabasePath) {
    const TemporaryFolder folder;
    folder.write("garden.treewind", oneTreeDocument);
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->getDatabasePathList().push_back(folder.path());
    EXPECT_TRUE(osgDB::readRefNodeFile("garden.treewind", options));
}

TEST_F(ReaderWriterTreewindTest, IsThreadSafe) {
    std::vector<osg::ref_ptr<Forest>> forests(4);
    std::vector<std::thread> pagers;
    for (osg::ref_ptr<Forest>& forest : forests)
        pagers.emplace_back([&forest] { forest = readForestNode(exampleFile("thesis.treewind")); });
    for (std::thread& pager : pagers)
        pager.join();
    for (const osg::ref_ptr<Forest>& forest : forests) {
        ASSERT_TRUE(forest);
        updateFrames(*forest, 1, 5);
        EXPECT_EQ(statesOf(*forest), statesOf(*forests[0]));
    }
    EXPECT_EQ(messages(), "");
}

TEST_F(ReaderWriterTreewindTest, AWrittenForestMovesTheSame) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/again.treewind";
    osg::ref_ptr<Forest> forest = readForestNode(exampleFile("forest.treewind"));
    ASSERT_TRUE(forest);
    ASSERT_TRUE(osgDB::writeNodeFile(*forest, file)) << messages();
    osg::ref_ptr<Forest> back = readForestNode(file);
    ASSERT_TRUE(back) << messages();
    updateFrames(*forest, 1, 10);
    updateFrames(*back, 1, 10);
    EXPECT_EQ(statesOf(*back), statesOf(*forest));
    EXPECT_EQ(messages(), "");
}

TEST_F(ReaderWriterTreewindTest, NamesTheNodeThatItCannotWrite) {
    std::ostringstream stream;
    const auto refusal = [&](const osg::Object& object) {
        return plugin()->writeObject(object, stream, nullptr).message();
    };
    EXPECT_EQ(refusal(*osg::ref_ptr<osg::Group>(new osg::Group)),
              "a .treewind file holds a Forest, not a Group");
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    EXPECT_TRUE(forest->setWind(std::make_shared<FunctionWind>(nullptr)).empty());
    EXPECT_EQ(refusal(*forest).find("wind: this wind cannot be written to a file"), 0u);
    forest->addChild(new osg::Group);
    forest->getChild(forest->getNumChildren() - 1)->setName("house");
    EXPECT_EQ(refusal(*forest), "a .treewind file does not hold the forest's child house");
    EXPECT_EQ(stream.str(), "");
    EXPECT_EQ(plugin()->writeNode(*forest, std::string("a.obj"), nullptr).status(),
              osgDB::ReaderWriter::WriteResult::FILE_NOT_HANDLED);
}

TEST_F(ReaderWriterTreewindTest, PlacesTheForestOnTheHostsMap) {
    const auto placeOf = [](const std::string& host) {
        std::istringstream input(
            "version = 1\ncrs = \"EPSG:25832\"\norigin = [500000.0, 5500000.0, 100.0]\n" + host +
            "[[tree]]\nposition = [500010.0, 5500020.0, 100.0]\n");
        const osg::ref_ptr<osg::Node> node = plugin()->readNode(input, nullptr).takeNode();
        EXPECT_TRUE(node);
        const osg::Transform* transform = node ? node->asTransform() : nullptr;
        return transform ? transform->asMatrixTransform()->getMatrix() : osg::Matrixd();
    };
    EXPECT_TRUE(placeOf("").isIdentity());
    EXPECT_EQ(placeOf("host_crs = \"EPSG:25832\"\n"), osg::Matrixd::translate(500000.0, 5500000.0, 100.0));
    // PROJ 9.1 (cs2cs) from EPSG:25832 to EPSG:25833: the origin, and the place 1 km east of it.
    const osg::Matrixd next = placeOf("host_crs = \"EPSG:25833\"\n");
    EXPECT_LT((next.getTrans() - osg::Vec3d(67034.9403, 5517306.7404, 100.0)).length(), 0.001);
    EXPECT_LT((osg::Vec3d(1000.0, 0.0, 0.0) * next - osg::Vec3d(68034.0389, 5517226.7087, 100.0)).length(),
              0.05);
    EXPECT_EQ(next(2, 2), 1.0) << "heights are unchanged";
}

TEST_F(ReaderWriterTreewindTest, AnUnknownHostMapIsAnErrorWithItsLine) {
    const auto problemOf = [](const std::string& text) {
        std::istringstream input("version = 1\n" + text + "[[tree]]\nposition = [1.0, 2.0]\n");
        return plugin()->readNode(input, nullptr).message();
    };
    EXPECT_EQ(problemOf("host_crs = \"EPSG:25833\"\n"), ":2:12: host_crs: needs the crs of the forest");
    EXPECT_NE(problemOf("crs = \"EPSG:25832\"\nhost_crs = \"EPSG:4326\"\n").find(":3:12: host_crs: "),
              std::string::npos);
    EXPECT_NE(problemOf("crs = \"EPSG:25832\"\nhost_crs = \"nowhere\"\n").find(":3:12: host_crs: "),
              std::string::npos);
}

TEST_F(ReaderWriterTreewindTest, OmitsTheHostMapTransformWhenWriting) {
    std::istringstream input(
        "version = 1\ncrs = \"EPSG:25832\"\nhost_crs = \"EPSG:25833\"\norigin = [500000.0, 5500000.0, "
        "0.0]\n[[tree]]\nposition = [500010.0, 5500020.0, 0.0]\n");
    const osg::ref_ptr<osg::Node> node = plugin()->readNode(input, nullptr).takeNode();
    std::ostringstream output;
    EXPECT_TRUE(plugin()->writeNode(*node, output, nullptr).success());
    EXPECT_NE(output.str().find("host_crs = \"EPSG:25833\""), std::string::npos) << output.str();
}
