// SPDX-License-Identifier: MIT
// The attributes that a forest adds to the statistics of a view.
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/forest/ForestDescription.h>

#include <osg/Stats>

using namespace osgTreeWind;

namespace {

class ForestStatisticsGlTest : public GlTest {
protected:
    void show(const ForestDescription& description) {
        open(160, 120);
        viewer().setSceneData(new Forest(description));
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, 160.0 / 120.0, 1, 100);
        viewer().getCamera()->setViewMatrixAsLookAt({4.5f, -14, 4}, {4.5f, 0, 3}, osg::Z_AXIS);
    }
    /// An attribute of the last frame; -1 if it is not set.
    double attribute(const char* name) {
        double value = -1.0;
        viewer().getViewerStats()->getAttribute(viewer().getFrameStamp()->getFrameNumber(), name, value);
        return value;
    }
};

} // namespace

TEST_F(ForestStatisticsGlTest, ReportsTimingsAndTrees) {
    show(smallForest(8));
    viewer().getViewerStats()->collectStats("update", true);
    for (int i = 0; i < 3; ++i)
        frame(i / 25.0);
    EXPECT_GT(attribute("Forest step"), 0.0);
    EXPECT_LT(attribute("Forest step"), 10.0);
    EXPECT_GT(attribute("Forest cull"), 0.0);
    EXPECT_GT(attribute("Forest pose"), 0.0);
    EXPECT_GT(attribute("Forest draw"), 0.0);
    EXPECT_EQ(attribute("Forest trees"), 8.0);
    const double drawn = attribute("Forest trees in full") + attribute("Forest trees by boughs") +
                         attribute("Forest trees as pictures");
    EXPECT_GE(drawn, 8.0);
    EXPECT_LE(drawn, 16.0) << "a tree between two tiers counts in both";
    viewer().getCamera()->setViewMatrixAsLookAt({4.5f, -14, 4}, {4.5f, -30, 3}, osg::Z_AXIS);
    frame(0.2);
    EXPECT_EQ(attribute("Forest trees"), 8.0);
    EXPECT_EQ(attribute("Forest trees in full") + attribute("Forest trees by boughs") +
                  attribute("Forest trees as pictures"),
              0.0);
}

TEST_F(ForestStatisticsGlTest, ReportsNothingUnlessCollected) {
    show(smallForest(8));
    frame(0.0);
    EXPECT_EQ(attribute("Forest step"), -1.0);
}

TEST_F(ForestStatisticsGlTest, ReportsNoTiersUnderABranchLaw) {
    ForestDescription forest = smallForest(4);
    forest.law = MotionLaw::ThesisSmooth;
    show(forest);
    viewer().getViewerStats()->collectStats("update", true);
    frame(0.0);
    EXPECT_GE(attribute("Forest step"), 0.0);
    EXPECT_EQ(attribute("Forest trees"), 4.0);
    EXPECT_GT(attribute("Forest draw"), 0.0);
    EXPECT_EQ(attribute("Forest pose"), -1.0);
    EXPECT_EQ(attribute("Forest trees in full"), -1.0);
}
