// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/gl/ThreadingModels.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/Geometry>
#include <osg/LightSource>
#include <osg/Texture2D>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ViewDependentShadowMap>
#include <osgViewer/CompositeViewer>

#include <array>

using namespace osgTreeWind;

namespace {

constexpr int viewWidth = 96, viewHeight = 72;

/// Two rows of four, at all tiers.
ForestDescription tieredForest() {
    ForestDescription description = smallForest(8);
    description.drawing.full = 40.0f;
    description.drawing.reduced = 32.0f;
    description.drawing.impostor = 26.0f;
    return description;
}

/// A camera that draws the node into a texture before the others do.
osg::ref_ptr<osg::Camera> intoTexture(osg::Node* node, osg::Texture2D* texture) {
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    lookAtSmallForest(*camera);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setViewport(0, 0, viewWidth, viewHeight);
    camera->attach(osg::Camera::COLOR_BUFFER, texture);
    camera->addChild(node);
    return camera;
}

/// The forest with its shadow, and a screen beside it with a picture of the forest.
osg::ref_ptr<osg::Node> shadowsAndScreen(Forest* forest) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(viewWidth, viewHeight);
    texture->setInternalFormat(GL_RGBA);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    osg::ref_ptr<osg::Geometry> screen =
        osg::createTexturedQuadGeometry({6, -4, 0}, osg::X_AXIS * 4.0f, osg::Z_AXIS * 3.0f);
    screen->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    screen->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);

    osg::ref_ptr<osgShadow::ShadowedScene> shadowed =
        new osgShadow::ShadowedScene(new osgShadow::ViewDependentShadowMap);
    shadowed->getShadowSettings()->setTextureSize({128, 128});
    shadowed->getShadowSettings()->setNumShadowMapsPerLight(2);
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition({0.5f, -1.0f, 2.0f, 0.0f});
    shadowed->addChild(sun);
    shadowed->addChild(osg::createTexturedQuadGeometry({-5, -8, 0}, {20, 0, 0}, {0, 20, 0}));
    shadowed->addChild(forest);

    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(intoTexture(forest, texture));
    scene->addChild(screen);
    scene->addChild(shadowed);
    return scene;
}

class ManyCamerasGlTest : public GlTest,
                          public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel> {
protected:
    using Pictures = std::array<osg::ref_ptr<osg::Image>, 2>;

    /// Opens two views of a scene, each in its own context.
    void show(osg::Node* scene, osgViewer::ViewerBase::ThreadingModel threading) {
        _viewer = new osgViewer::CompositeViewer;
        _viewer->setThreadingModel(threading);
        for (osg::ref_ptr<osg::Image>& image : _images) {
            auto made = createOffscreenContext(viewWidth, viewHeight);
            ASSERT_TRUE(made);
            made.value()->getState()->setCheckForGLErrors(osg::State::ONCE_PER_ATTRIBUTE);
            osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
            image = attachFrameImage(*view->getCamera(), *made.value());
            lookAtSmallForest(*view->getCamera());
            view->setSceneData(scene);
            _viewer->addView(view);
        }
    }
    /// Draws frames, and returns the pictures of both views after frame `last`.
    Pictures run(int first, int last) {
        for (int i = first; i <= last; ++i)
            _viewer->frame(i / 25.0);
        _viewer->stopThreading();
        EXPECT_EQ(takeMessages(), "");
        Pictures pictures;
        for (std::size_t i = 0; i < 2; ++i)
            pictures[i] = new osg::Image(*_images[i], osg::CopyOp::DEEP_COPY_ALL);
        _viewer->startThreading();
        return pictures;
    }
    void TearDown() override {
        _viewer = nullptr;
        GlTest::TearDown();
    }

    osg::ref_ptr<osgViewer::CompositeViewer> _viewer;
    Pictures _images;
};

} // namespace

TEST_P(ManyCamerasGlTest, AllShowTheSamePoses) {
    osg::ref_ptr<osg::Node> scene = shadowsAndScreen(new Forest(tieredForest()));
    show(scene, osgViewer::ViewerBase::SingleThreaded);
    const Pictures third = run(1, 3), thirtieth = run(4, 30);
    EXPECT_GT(covered(*third[0]), 0.3);
    EXPECT_GT(difference(*third[0], *thirtieth[0]).mean, 0.3) << "frames 3 and 30 are alike";

    scene = shadowsAndScreen(new Forest(tieredForest()));
    show(scene, GetParam());
    for (const osg::ref_ptr<osg::Image>& picture : run(1, 3))
        EXPECT_EQ(difference(*picture, *third[0]).mean, 0.0);
    for (const osg::ref_ptr<osg::Image>& picture : run(4, 30))
        EXPECT_EQ(difference(*picture, *thirtieth[0]).mean, 0.0);
}

TEST_P(ManyCamerasGlTest, AForestIsAddedAndRemovedWhileOthersAreDrawn) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> stays = new Forest(tieredForest());
    scene->addChild(stays);
    show(scene, GetParam());
    for (int i = 0; i < 40; ++i) {
        if (i % 4 == 1)
            scene->addChild(new Forest(*stays)); // shares shapes and programs
        if (i % 4 == 3)
            scene->removeChild(1);
        run(i, i);
    }
    scene->removeChild(0, 1);
    EXPECT_EQ(covered(*run(40, 40)[1]), 0.0);
}

TEST_P(ManyCamerasGlTest, AReleasedForestIsDrawnAgain) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest(tieredForest());
    scene->addChild(forest);
    show(scene, GetParam());
    run(1, 5);
    const Pictures before = run(5, 5);
    scene->removeChild(forest);
    _viewer->stopThreading();
    forest->releaseGLObjects();
    EXPECT_EQ(covered(*run(5, 5)[0]), 0.0);
    scene->addChild(forest);
    for (const osg::ref_ptr<osg::Image>& picture : run(5, 5))
        EXPECT_EQ(difference(*picture, *before[0]).mean, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Models, ManyCamerasGlTest, threadingModels, nameOfModel);
