// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <tests/gl/GlTest.h>

#include <osg/Geometry>
#include <osg/Program>
#include <osgViewer/CompositeViewer>

#include <limits>
#include <set>
#include <thread>

using namespace osgTreeWind;

namespace {

osg::ref_ptr<osg::GraphicsContext> realizedContext(int width, int height,
                                                   ContextProfile profile = osgProfile) {
    auto made = createOffscreenContext(width, height, profile);
    if (!made) {
        ADD_FAILURE() << made.problems().front().message;
        return nullptr;
    }
    EXPECT_TRUE(made.value()->realize());
    return made.value();
}

/// Clears the frame buffer to a colour. @return the bottom left pixel.
osg::Vec4ub clearAndRead(float red, float green, float blue) {
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    osg::Vec4ub pixel;
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.ptr());
    return pixel;
}

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

osg::ref_ptr<osg::Geometry> quad(const osg::Vec3& corner, const osg::Vec3& width, const osg::Vec3& height) {
    osg::ref_ptr<osg::Geometry> geometry = osg::createTexturedQuadGeometry(corner, width, height);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

class OffscreenContextGlTest : public GlTest {};

} // namespace

TEST_F(OffscreenContextGlTest, RejectsSizesOutOfRange) {
    const int big = std::numeric_limits<int>::max();
    for (const auto& [width, height] :
         {std::pair(0, 8), {8, 0}, {-1, 8}, {8, -1}, {16385, 8}, {8, 16385}, {big, big}}) {
        const auto made = createOffscreenContext(width, height);
        ASSERT_FALSE(made) << width << "x" << height;
        const std::string message = made.problems().front().message;
        EXPECT_NE(message.find(std::to_string(width) + "x" + std::to_string(height)), std::string::npos)
            << message;
        EXPECT_NE(message.find("1 to 16384"), std::string::npos) << message;
    }
}

TEST_F(OffscreenContextGlTest, AcceptsExtremeSizes) {
    for (const auto& [width, height] : {std::pair(1, 1), {16384, 1}, {1, 16384}}) {
        auto context = realizedContext(width, height);
        ASSERT_TRUE(context && context->makeCurrent()) << width << "x" << height;
        EXPECT_EQ(clearAndRead(0, 1, 0), osg::Vec4ub(0, 255, 0, 255)) << width << "x" << height;
        context->releaseContext();
    }
}

TEST_F(OffscreenContextGlTest, LeavesNoContextCurrent) {
    const GLubyte* const before = glGetString(GL_VERSION);
    auto context = realizedContext(8, 8);
    EXPECT_EQ(before, nullptr);
    EXPECT_EQ(glGetString(GL_VERSION), nullptr);
}

TEST_F(OffscreenContextGlTest, OffersOpenGL33InBothProfiles) {
    for (const ContextProfile profile : {ContextProfile::Compatibility, ContextProfile::Core}) {
        auto context = realizedContext(8, 8, profile);
        ASSERT_TRUE(context && context->makeCurrent());
        EXPECT_GE(integer(GL_MAJOR_VERSION) * 10 + integer(GL_MINOR_VERSION), 33) << glGetString(GL_VERSION);
        EXPECT_TRUE(integer(GL_CONTEXT_PROFILE_MASK) &
                    (profile == ContextProfile::Core ? GL_CONTEXT_CORE_PROFILE_BIT
                                                     : GL_CONTEXT_COMPATIBILITY_PROFILE_BIT));
        EXPECT_EQ(isCoreProfile(*context->getState()),
                  profile == ContextProfile::Core || osgProfile == ContextProfile::Core);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        context->releaseContext();
    }
}

#ifdef OSG_GL_VERTEX_FUNCS_AVAILABLE
TEST_F(OffscreenContextGlTest, HasTheFixedFunctionInACompatibilityProfile) {
    auto context = realizedContext(8, 8);
    ASSERT_TRUE(context && context->makeCurrent());
    glColor3f(1, 0, 0);
    glBegin(GL_QUADS);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
    osg::Vec4ub pixel;
    glReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.ptr());
    EXPECT_EQ(pixel, osg::Vec4ub(255, 0, 0, 255));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    context->releaseContext();
}

TEST_F(OffscreenContextGlTest, HasTheDocumentedDepthAndStencilBits) {
    auto context = realizedContext(8, 8);
    ASSERT_TRUE(context && context->makeCurrent());
    EXPECT_EQ(integer(GL_DEPTH_BITS), 24);
    EXPECT_EQ(integer(GL_STENCIL_BITS), 8);
    EXPECT_EQ(integer(GL_ALPHA_BITS), 8);
    context->releaseContext();
}
#endif

TEST_F(OffscreenContextGlTest, TwoContextsHaveTheirOwnIdsAndPixels) {
    auto first = realizedContext(8, 8);
    auto second = realizedContext(16, 16);
    ASSERT_TRUE(first && second);
    EXPECT_NE(first->getState()->getContextID(), second->getState()->getContextID());
    first->makeCurrent();
    clearAndRead(1, 0, 0);
    first->releaseContext();
    second->makeCurrent();
    EXPECT_EQ(clearAndRead(0, 0, 1), osg::Vec4ub(0, 0, 255, 255));
    second->releaseContext();
    second = nullptr;
    first->makeCurrent();
    osg::Vec4ub pixel;
    glReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.ptr());
    EXPECT_EQ(pixel, osg::Vec4ub(255, 0, 0, 255)) << "the first context lost its pixels with the second";
    first->releaseContext();
}

TEST_F(OffscreenContextGlTest, FiftyContextsInTurnReuseTheirIds) {
    osg::ref_ptr<osg::Node> node = quad(osg::Vec3(-1, 0, -1), osg::Vec3(2, 0, 0), osg::Vec3(0, 0, 2));
    std::set<unsigned int> ids;
    for (int i = 0; i < 50; ++i) {
        open(16, 16);
        viewer().setSceneData(node);
        viewer().getCamera()->setProjectionMatrixAsOrtho(-1, 1, -1, 1, 0, 10);
        viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(0, -5, 0), osg::Vec3(), osg::Vec3(0, 0, 1));
        frame(0);
        EXPECT_NE(pixel(8, 8), osg::Vec4ub(0, 0, 0, 255)) << "nothing drawn in context " << i;
        ids.insert(context().getState()->getContextID());
    }
    // open() closes the last context before it makes the next.
    EXPECT_EQ(ids.size(), 1u);
}

TEST_F(OffscreenContextGlTest, ClosesWithItsLastReference) {
    std::size_t before = 0;
    for (int i = 0; i < 50; ++i) {
        auto context = realizedContext(512, 512);
        ASSERT_TRUE(context && context->makeCurrent());
        clearAndRead(1, 0, 0);
        context->releaseContext();
        if (i == 10)
            before = residentMemory();
    }
    // A leaked context of this size takes over 4 MiB.
    EXPECT_LT(residentMemory(), before + 2 * keptMemory);
}

TEST_F(OffscreenContextGlTest, AClosedContextIsInvalid) {
    auto context = realizedContext(8, 8);
    ASSERT_TRUE(context);
    context->close();
    EXPECT_FALSE(context->valid());
    EXPECT_FALSE(context->isRealized());
    EXPECT_FALSE(context->makeCurrentImplementation());
    context->close();
}

TEST_F(OffscreenContextGlTest, MovesToAnotherThread) {
    auto context = realizedContext(8, 8);
    ASSERT_TRUE(context);
    osg::Vec4ub there;
    std::thread([&] {
        ASSERT_TRUE(context->makeCurrent());
        there = clearAndRead(1, 1, 0);
        context->releaseContext();
    }).join();
    EXPECT_EQ(there, osg::Vec4ub(255, 255, 0, 255));
    ASSERT_TRUE(context->makeCurrent());
    EXPECT_EQ(clearAndRead(0, 1, 1), osg::Vec4ub(0, 255, 255, 255));
    context->releaseContext();
}

TEST_F(OffscreenContextGlTest, DrawsInEveryThreadingModel) {
    for (const auto model :
         {osgViewer::ViewerBase::SingleThreaded, osgViewer::ViewerBase::CullDrawThreadPerContext,
          osgViewer::ViewerBase::DrawThreadPerContext,
          osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext}) {
        open(16, 16);
        viewer().setThreadingModel(model);
        viewer().getCamera()->setClearColor(osg::Vec4(0, 1, 0, 1));
        for (int i = 0; i < 5; ++i)
            viewer().frame(i / 25.0);
        viewer().stopThreading();
        EXPECT_EQ(takeMessages(), "") << "threading model " << model;
        EXPECT_EQ(pixel(8, 8), osg::Vec4ub(0, 255, 0, 255)) << "threading model " << model;
    }
}

TEST_F(OffscreenContextGlTest, ServesTwoViewsOfACompositeViewer) {
    auto context = realizedContext(16, 8);
    ASSERT_TRUE(context);
    osgViewer::CompositeViewer composite;
    composite.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    for (int i = 0; i < 2; ++i) {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        view->getCamera()->setGraphicsContext(context);
        view->getCamera()->setViewport(8 * i, 0, 8, 8);
        view->getCamera()->setClearColor(osg::Vec4(i, 1 - i, 0, 1));
        composite.addView(view);
    }
    composite.frame(0);
    ASSERT_TRUE(context->makeCurrent());
    osg::Vec4ub left, right;
    glReadPixels(7, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, left.ptr());
    glReadPixels(8, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, right.ptr());
    EXPECT_EQ(left, osg::Vec4ub(0, 255, 0, 255));
    EXPECT_EQ(right, osg::Vec4ub(255, 0, 0, 255));
    context->releaseContext();
}

TEST_F(OffscreenContextGlTest, FloatTargetsKeepValuesBelowZeroAndAboveOne) {
    const osg::Vec4 value(-2.5f, 1e6f, 0.1f, 7.0f);
    osg::ref_ptr<osg::Image> target = new osg::Image;
    target->allocateImage(4, 4, 1, GL_RGBA, GL_FLOAT);
    target->setInternalTextureFormat(GL_RGBA32F_ARB);

    open(16, 16);
    osg::ref_ptr<osg::Camera> pass = new osg::Camera;
    pass->setRenderOrder(osg::Camera::PRE_RENDER);
    pass->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    pass->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    pass->setViewport(0, 0, 4, 4);
    pass->setProjectionMatrixAsOrtho2D(-1, 1, -1, 1);
    pass->attach(osg::Camera::COLOR_BUFFER, target);
    pass->addChild(quad(osg::Vec3(-1, -1, 0), osg::Vec3(2, 0, 0), osg::Vec3(0, 2, 0)));
    osg::StateSet* const state = pass->getOrCreateStateSet();
    state->setAttributeAndModes(osgTreeWind::makeProgram(
        "value", "void main() { gl_Position = osg_ProjectionMatrix * osg_ModelViewMatrix * osg_Vertex; }",
        "uniform vec4 value;\nout vec4 color;\nvoid main() { color = value; }"));
    state->addUniform(new osg::Uniform("value", value));
    viewer().setSceneData(pass);
    frame(0);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(reinterpret_cast<const float*>(target->data(3, 3))[i], value[i]) << "component " << i;
}
