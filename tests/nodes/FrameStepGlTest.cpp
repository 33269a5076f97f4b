// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

using namespace osgTreeWind;

namespace {

class FrameStepGlTest : public GlTest {
protected:
    /// The 20th frame of a run with irregular frame times.
    osg::ref_ptr<osg::Image> run(double (*hostTime)(int)) {
        open(96, 72);
        viewer().setSceneData(new Forest(smallForest(3)));
        lookAtSmallForest(*viewer().getCamera());
        for (int i = 1; i <= 20; ++i)
            frame(hostTime(i));
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

} // namespace

TEST_F(FrameStepGlTest, GivesTwoRunsTheSamePictures) {
    const auto slow = [](int i) { return 0.11 * i; };
    const auto quick = [](int i) { return 0.02 * i + 0.003 * (i % 3); };
    EXPECT_GT(difference(*run(slow), *run(quick)).mean, 0.1);
    const EnvironmentVariable step("OSGTREEWIND_STEP", "0.04");
    EXPECT_EQ(difference(*run(slow), *run(quick)).mean, 0.0);
}
