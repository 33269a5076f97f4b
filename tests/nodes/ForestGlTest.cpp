// SPDX-License-Identifier: MIT
#include <tests/NamesInOrder.h>
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgUtil/Optimizer>
#include <osgViewer/CompositeViewer>

using namespace osgTreeWind;

namespace {

class ForestGlTest : public GlTest {
protected:
    static constexpr int width = 160, height = 120;

    /// The last of `frames` frames, which begin at time 0, 1/25 s apart. The camera is independent of bounds.
    osg::ref_ptr<osg::Image> picture(osg::Node* scene, int frames) {
        open(width, height);
        viewer().setSceneData(scene);
        lookAtSmallForest(*viewer().getCamera());
        return renderFrames(0, frames - 1);
    }
    osg::ref_ptr<osg::Image> renderFrames(int first, int last) {
        for (int i = first; i <= last; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

} // namespace

TEST_F(ForestGlTest, DrawsTrees) {
    osg::ref_ptr<osg::Image> still = picture(new Forest(smallForest(4)), 1);
    EXPECT_GT(covered(*still), 0.05);
    EXPECT_LT(covered(*still), 0.6);
}

TEST_F(ForestGlTest, DrawsNothingWithoutTrees) {
    EXPECT_EQ(covered(*picture(new Forest, 3)), 0.0);
}

TEST_F(ForestGlTest, FramesDifferInWind) {
    osg::ref_ptr<osg::Image> first = picture(new Forest(smallForest(4)), 2);
    EXPECT_GT(difference(*first, *renderFrames(2, 25)).mean, 0.3);
}

TEST_F(ForestGlTest, FramesAreEqualWhilePaused) {
    osg::ref_ptr<osg::Image> first = picture(new Forest(smallForest(4)), 10);
    frame(9 / 25.0);
    frame(9 / 25.0);
    EXPECT_EQ(difference(*first, image()).mean, 0.0);
}

TEST_F(ForestGlTest, ThePictureIsTheSameFarFromTheWorldOrigin) {
    ForestDescription close = smallForest(4), distant = smallForest(4);
    distant.origin = {4.3e5, 4.5e6, 1402.0};
    for (TreePlacement& tree : distant.trees)
        tree.position += distant.origin;
    osg::ref_ptr<osg::Image> here = picture(new Forest(close), 10), there = picture(new Forest(distant), 10);
    EXPECT_GT(covered(*here), 0.05);
    EXPECT_EQ(difference(*here, *there).mean, 0.0);
}

TEST_F(ForestGlTest, ThePictureIsTheSameBelowAFarTransformExceptForRounding) {
    const osg::Vec3d away(4.3e5, 4.5e6, 1402.0);
    osg::ref_ptr<osg::Image> here = picture(new Forest(smallForest(4)), 1);
    osg::ref_ptr<osg::MatrixTransform> there = new osg::MatrixTransform(osg::Matrix::translate(away));
    there->addChild(new Forest(smallForest(4)));
    picture(there, 1);
    viewer().getCamera()->setViewMatrix(osg::Matrix::translate(-away) *
                                        viewer().getCamera()->getViewMatrix());
    EXPECT_LT(difference(*here, *renderFrames(0, 0)).mean, 0.5);
}

TEST_F(ForestGlTest, ANewDescriptionIsDrawnInTheNextFrame) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    osg::ref_ptr<osg::Image> one = picture(forest, 3);
    EXPECT_TRUE(forest->setDescription(ForestDescription()).empty());
    EXPECT_EQ(covered(*renderFrames(3, 3)), 0.0);
    EXPECT_TRUE(forest->setDescription(smallForest(1)).empty());
    EXPECT_LT(difference(*one, *renderFrames(4, 5)).mean, 1.0);
}

TEST_F(ForestGlTest, TwoViewsShowTheSameForestAndStepItOnce) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2)), alone = new Forest(smallForest(2));
    picture(alone, 10);
    open(8, 8); // collects messages; the viewer below has its own contexts
    osgViewer::CompositeViewer composite;
    composite.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    osg::ref_ptr<osg::Image> images[2];
    std::vector<osg::ref_ptr<osg::GraphicsContext>> contexts;
    for (osg::ref_ptr<osg::Image>& image : images) {
        auto made = createOffscreenContext(width, height);
        ASSERT_TRUE(made);
        contexts.push_back(made.value());
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        image = attachFrameImage(*view->getCamera(), *contexts.back());
        lookAtSmallForest(*view->getCamera());
        view->setSceneData(forest);
        composite.addView(view);
    }
    for (int i = 0; i < 10; ++i)
        composite.frame(i / 25.0);
    EXPECT_EQ(statesOf(*forest), statesOf(*alone));
    EXPECT_GT(covered(*images[0]), 0.02);
    EXPECT_EQ(difference(*images[0], *images[1]).mean, 0.0);
}

class OptimizedForestGlTest : public ForestGlTest, public ::testing::WithParamInterface<unsigned> {};

TEST_P(OptimizedForestGlTest, GivesTheSamePicture) {
    osg::ref_ptr<osg::Group> plain = new osg::Group, optimized = new osg::Group;
    for (osg::Group* scene : {plain.get(), optimized.get()}) {
        osg::ref_ptr<osg::MatrixTransform> turned =
            new osg::MatrixTransform(osg::Matrix::rotate(0.3, osg::Z_AXIS) * osg::Matrix::translate(1, 2, 0));
        turned->addChild(new Forest(smallForest(8)));
        scene->addChild(turned);
        scene->addChild(new Forest(smallForest(4)));
    }
    osgUtil::Optimizer().optimize(optimized, GetParam());
    osg::ref_ptr<osg::Image> a = picture(plain, 10), b = picture(optimized, 10);
    EXPECT_LT(difference(*a, *b).mean, 0.5);
    EXPECT_LT(difference(*a, *b).outliers, 0.002);
}

INSTANTIATE_TEST_SUITE_P(DefaultAndAll, OptimizedForestGlTest,
                         ::testing::Values(osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS,
                                           osgUtil::Optimizer::ALL_OPTIMIZATIONS),
                         NamesInOrder({"Default", "All"}));
