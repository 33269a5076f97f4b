// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/gl/ThreadingModels.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

using namespace osgTreeWind;

namespace {

/// The threading models of stock osgviewer.
class ThreadedForestGlTest : public GlTest,
                             public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel> {
protected:
    void start(osgViewer::ViewerBase::ThreadingModel threading) {
        open(96, 72);
        osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
        viewer().setSceneData(forest);
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrixAsPerspective(40, 96.0 / 72.0, 1, 100);
        camera.setViewMatrixAsLookAt(osg::Vec3(3, -14, 4), osg::Vec3(3, 0, 3), osg::Z_AXIS);
        viewer().setThreadingModel(threading);
    }
    /// Draws frames, and returns the picture of frame `last`.
    osg::ref_ptr<osg::Image> run(int first, int last) {
        for (int i = first; i <= last; ++i)
            frame(i / 25.0);
        viewer().stopThreading();
        osg::ref_ptr<osg::Image> picture = new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
        viewer().startThreading();
        return picture;
    }
};

} // namespace

TEST_P(ThreadedForestGlTest, ShowsThePicturesOfASingleThread) {
    start(osgViewer::ViewerBase::SingleThreaded);
    osg::ref_ptr<osg::Image> tenth = run(1, 10), sixtieth = run(11, 60);
    start(GetParam());
    EXPECT_EQ(difference(*run(1, 10), *tenth).mean, 0.0);
    EXPECT_EQ(difference(*run(11, 60), *sixtieth).mean, 0.0);
    EXPECT_GT(difference(*tenth, *sixtieth).mean, 0.3) << "frames 10 and 60 are alike";
}

INSTANTIATE_TEST_SUITE_P(Models, ThreadedForestGlTest,
                         ::testing::Values(osgViewer::ViewerBase::CullDrawThreadPerContext,
                                           osgViewer::ViewerBase::DrawThreadPerContext,
                                           osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext),
                         nameOfModel);
