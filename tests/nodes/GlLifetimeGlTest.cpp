// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osg/BufferObject>
#include <osg/ContextData>
#include <osg/Texture>
#include <osgUtil/GLObjectsVisitor>

using namespace osgTreeWind;

namespace {

class GlLifetimeGlTest : public GlTest {
protected:
    static constexpr int width = 96, height = 72;

    unsigned contextID() { return context().getState()->getContextID(); }
    /// Bytes of the buffers and textures in OSG's pools for the context, in use or free.
    std::size_t poolSize() {
        return osg::get<osg::GLBufferObjectManager>(contextID())->getCurrGLBufferObjectPoolSize() +
               osg::get<osg::TextureObjectManager>(contextID())->getCurrTexturePoolSize();
    }
};

} // namespace

TEST_F(GlLifetimeGlTest, AForestMovesFromOneContextToAnother) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<osg::Image> first = render(forest, width, height, 1);
    viewer().setSceneData(nullptr);
    forest->releaseGLObjects(context().getState());
    osg::ref_ptr<osg::Image> second = render(forest, width, height, 1);
    EXPECT_GT(covered(*first), 0.02);
    EXPECT_EQ(difference(*first, *second).mean, 0.0);
}

TEST_F(GlLifetimeGlTest, AForestReleasedForAllContextsIsDrawnAgain) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<osg::Image> first = render(forest, width, height, 3);
    forest->releaseGLObjects();
    frame(2 / 25.0);
    EXPECT_EQ(difference(*first, image()).mean, 0.0);
}

TEST_F(GlLifetimeGlTest, BuffersAreResizedForMoreContexts) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<osg::Image> first = render(forest, width, height, 3);
    forest->resizeGLObjectBuffers(64);
    frame(2 / 25.0);
    EXPECT_EQ(difference(*first, image()).mean, 0.0);
}

TEST_F(GlLifetimeGlTest, TheFiftiethForestLooksLikeTheFirst) {
    std::vector<osg::ref_ptr<Forest>> held;
    for (int i = 0; i < 50; ++i)
        held.push_back(new Forest(smallForest(2)));
    const osg::ref_ptr<osg::Image> first = render(held.front(), width, height, 3);
    EXPECT_GT(covered(*first), 0.02);
    EXPECT_EQ(difference(*first, *render(held.back(), width, height, 3)).mean, 0.0);
}

TEST_F(GlLifetimeGlTest, ReleasingOneForestKeepsOthersThatShareItsParts) {
    osg::ref_ptr<Forest> kept = new Forest(smallForest(2)), gone = new Forest(smallForest(2));
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(kept);
    scene->addChild(gone);
    osg::ref_ptr<osg::Image> both = render(scene, width, height, 3);
    scene->removeChild(gone);
    gone->releaseGLObjects(context().getState());
    frame(2 / 25.0);
    EXPECT_EQ(difference(*both, image()).mean, 0.0) << "they stood in one place";
    gone = nullptr;
    frame(2 / 25.0);
    EXPECT_EQ(difference(*both, image()).mean, 0.0);
    kept->releaseGLObjects();
    frame(2 / 25.0);
    EXPECT_EQ(difference(*both, image()).mean, 0.0);
}

// On Windows a program cannot ask for the managers of OSG: osg::get() finds them by the address of a
// type_info, of which each DLL has its own.
#ifndef _WIN32
TEST_F(GlLifetimeGlTest, ReleasingFreesAllBuffersAndTextures) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    render(forest, width, height, 1);
    viewer().setSceneData(new osg::Group);
    frame(0.0);
    auto* buffers = osg::get<osg::GLBufferObjectManager>(contextID());
    auto* textures = osg::get<osg::TextureObjectManager>(contextID());
    ASSERT_GT(buffers->getNumberActiveGLBufferObjects(), 0u);
    ASSERT_GE(textures->getNumberActiveTextureObjects(), 4u) << "poses, bark and blades";
    forest->releaseGLObjects(context().getState());
    for (int i = 1; i < 100 && textures->getNumberActiveTextureObjects() > 0; ++i)
        frame(0.04 * i); // each frame deletes as many objects as its time allows
    EXPECT_EQ(buffers->getNumberActiveGLBufferObjects(), 0u);
    EXPECT_EQ(textures->getNumberActiveTextureObjects(), 0u);
}

TEST_F(GlLifetimeGlTest, CompilesAllGlObjectsAhead) {
    open(width, height);
    viewer().setSceneData(new osg::Group);
    frame(0.0);
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    auto* buffers = osg::get<osg::GLBufferObjectManager>(contextID());
    auto* textures = osg::get<osg::TextureObjectManager>(contextID());
    ASSERT_EQ(buffers->getNumberActiveGLBufferObjects(), 0u);
    context().makeCurrent();
    osgUtil::GLObjectsVisitor compile;
    compile.setState(context().getState());
    forest->accept(compile);
    context().releaseContext();
    const auto compiled = buffers->getNumberActiveGLBufferObjects();
    EXPECT_GE(compiled, 4u) << "bark and leaves of two models";
    EXPECT_GE(textures->getNumberActiveTextureObjects(), 4u) << "bark, blades and impostors";
    viewer().setSceneData(forest);
    frame(0.04);
    EXPECT_LE(buffers->getNumberActiveGLBufferObjects(), compiled + 8) << "except for lists of trees";
}

TEST_F(GlLifetimeGlTest, AHundredForestsLeakNothing) {
    open(width, height);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    viewer().setSceneData(scene);
    viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(0, -20, 3), osg::Vec3(0, 0, 3), osg::Z_AXIS);
    std::size_t settledPool = 0, settledMemory = 0;
    for (int i = 0; i < 100; ++i) {
        osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
        scene->addChild(forest);
        for (int k = 0; k < 3; ++k)
            frame((4 * i + k) / 25.0);
        scene->removeChild(forest);
        forest = nullptr;
        frame((4 * i + 3) / 25.0);
        if (i == 49) {
            settledPool = poolSize();
            settledMemory = residentMemory();
        }
    }
    EXPECT_LE(poolSize(), settledPool + settledPool / 10);
    EXPECT_LT(residentMemory(), settledMemory + keptMemory) << "50 forests of about 1 MB came and went";
}
#endif
