// SPDX-License-Identifier: MIT
#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <osgDB/ReadFile>
#include <osgGA/EventVisitor>
#include <osgViewer/Viewer>
#include <osgViewer/ViewerEventHandlers>

#include <gtest/gtest.h>

#include <string>

using namespace osgTreeWind;

namespace {

struct Lines : osgViewer::StatsHandler {
    std::size_t count() const { return _userStatsLines.size(); }
    bool has(const std::string& attribute) const {
        for (const UserStatsLine& line : _userStatsLines)
            if (line.timeTakenName == attribute)
                return true;
        return false;
    }
};

osg::ref_ptr<osg::Node> readForestNode() {
    usePluginsOfThisBuild();
    return osgDB::readRefNodeFile(exampleFile("thesis.treewind"));
}

} // namespace

TEST(StatisticsLinesCallbackTest, AddsTheLinesToAViewerOnce) {
    osg::ref_ptr<Lines> statistics = new Lines;
    osgViewer::Viewer viewer;
    viewer.addEventHandler(statistics);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(readForestNode());
    scene->addChild(readForestNode());
    osgGA::EventVisitor events;
    events.setActionAdapter(&viewer);
    for (int i = 0; i < 3; ++i)
        scene->accept(events);
    EXPECT_EQ(statistics->count(), 10u);
    EXPECT_TRUE(statistics->has("Forest step"));
    EXPECT_TRUE(statistics->has("Process memory"));
}

TEST(StatisticsLinesCallbackTest, IsSerializedAsAPlainCallback) {
    const osg::ref_ptr<osg::Node> forest = readForestNode();
    ASSERT_TRUE(forest->getEventCallback());
    EXPECT_EQ(std::string("osg::NodeCallback"), forest->getEventCallback()->libraryName() +
                                                    std::string("::") +
                                                    forest->getEventCallback()->className());
}
