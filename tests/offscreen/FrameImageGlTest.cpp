// SPDX-License-Identifier: MIT
#include <osgTreeWind/offscreen/FrameImage.h>

#include <tests/gl/GlTest.h>

#include <osg/Geometry>
#include <osg/ShapeDrawable>

#include <cstring>
#include <set>

namespace {

class FrameImageGlTest : public GlTest {
protected:
    /// Opens a view with one unit per pixel, the origin at the bottom left, y up.
    void openPixelView(int width, int height, int samples = 0) {
        open(width, height, samples);
        viewer().getCamera()->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        viewer().getCamera()->setProjectionMatrixAsOrtho(0, width, 0, height, -1, 1);
        viewer().getCamera()->setViewMatrix(osg::Matrix::identity());
    }
};

/// An unlit red shape in the plane z = 0.
osg::ref_ptr<osg::Geometry> redShape(std::initializer_list<osg::Vec3> corners) {
    osg::ref_ptr<osg::Geometry> shape = new osg::Geometry;
    shape->setVertexArray(new osg::Vec3Array(corners.begin(), corners.end()));
    osg::ref_ptr<osg::Vec4Array> red = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    red->push_back(osg::Vec4(1, 0, 0, 1));
    shape->setColorArray(red);
    shape->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, corners.size()));
    shape->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return shape;
}

} // namespace

TEST_F(FrameImageGlTest, AnEmptySceneHasTheClearColour) {
    for (const int samples : {0, 4}) {
        open(33, 17, samples);
        viewer().getCamera()->setClearColor(osg::Vec4(51 / 255.f, 102 / 255.f, 204 / 255.f, 1));
        frame(0);
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 33; ++x)
                ASSERT_EQ(pixel(x, y), osg::Vec4ub(51, 102, 204, 255))
                    << x << ", " << y << ", samples " << samples;
    }
}

TEST_F(FrameImageGlTest, AShapeCoversTheProjectedPixels) {
    openPixelView(40, 24);
    viewer().setSceneData(redShape({{6, 3, 0}, {20, 3, 0}, {20, 8, 0}, {6, 8, 0}}));
    frame(0);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 6 && x < 20 && y >= 3 && y < 8;
            ASSERT_EQ(pixel(x, y), osg::Vec4ub(inside ? 255 : 0, 0, 0, 255)) << x << ", " << y;
        }
}

TEST_F(FrameImageGlTest, TheBottomRowComesFirst) {
    openPixelView(8, 8);
    viewer().setSceneData(redShape({{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {0, 1, 0}}));
    frame(0);
    EXPECT_EQ(image().getOrigin(), osg::Image::BOTTOM_LEFT);
    EXPECT_EQ(image().data()[0], 255);
    EXPECT_EQ(image().data(0, 7)[0], 0);
}

TEST_F(FrameImageGlTest, SamplesSmoothTheEdgesOfAShape) {
    for (const int samples : {0, 1, 4}) {
        openPixelView(32, 32, samples);
        viewer().setSceneData(redShape({{0, 0, 0}, {32, 0, 0}, {0, 13, 0}}));
        frame(0);
        std::set<int> reds;
        for (int i = 0; i < 32 * 32; ++i)
            reds.insert(image().data()[4 * i]);
        if (samples > 1)
            EXPECT_GT(reds.size(), 2u) << samples << " samples";
        else
            EXPECT_EQ(reds, (std::set<int>{0, 255})) << samples << " samples";
    }
}

TEST_F(FrameImageGlTest, ClampsTheNumberOfSamples) {
    openPixelView(32, 32, 1000);
    viewer().setSceneData(redShape({{0, 0, 0}, {32, 0, 0}, {0, 13, 0}}));
    viewer().frame(0);
    std::set<int> reds;
    for (int i = 0; i < 32 * 32; ++i)
        reds.insert(image().data()[4 * i]);
    EXPECT_GT(reds.size(), 2u);
}

TEST_F(FrameImageGlTest, NearShapesHideFarOnes) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Geometry> hidden = redShape({{0, 0, -.5f}, {8, 0, -.5f}, {8, 8, -.5f}, {0, 8, -.5f}});
    osg::ref_ptr<osg::Geometry> seen = redShape({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
    (*static_cast<osg::Vec4Array*>(seen->getColorArray()))[0].set(0, 1, 0, 1);
    scene->addChild(seen);
    scene->addChild(hidden);
    openPixelView(8, 8);
    viewer().setSceneData(scene);
    frame(0);
    EXPECT_EQ(pixel(4, 4), osg::Vec4ub(0, 255, 0, 255));
}

TEST_F(FrameImageGlTest, TheSameSceneGivesTheSameBytes) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "OSG does not light shapes without a program in a core profile";
    osg::ref_ptr<osg::Node> cone = new osg::ShapeDrawable(new osg::Cone(osg::Vec3(), 1, 2));
    const osg::ref_ptr<osg::Image> first = render(cone, 64, 48, 3);
    const osg::ref_ptr<osg::Image> second = render(cone, 64, 48, 3);
    EXPECT_EQ(std::memcmp(first->data(), second->data(), first->getTotalSizeInBytes()), 0);
    EXPECT_GT(std::set<unsigned char>(first->data(), first->data() + first->getTotalSizeInBytes()).size(),
              20u)
        << "the cone is missing or unlit";
}

TEST_F(FrameImageGlTest, EachFrameUpdatesTheImage) {
    open(8, 8);
    for (const int red : {255, 0, 51}) {
        viewer().getCamera()->setClearColor(osg::Vec4(red / 255.f, 0, 0, 1));
        frame(0);
        EXPECT_EQ(pixel(0, 0), osg::Vec4ub(red, 0, 0, 255));
    }
}

TEST_F(FrameImageGlTest, MayBeLargerThanTheContext) {
    open(1, 1);
    const osg::ref_ptr<osg::Image> drawn =
        osgTreeWind::attachFrameImage(*viewer().getCamera(), context(), 300, 20, 0);
    viewer().getCamera()->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    viewer().getCamera()->setProjectionMatrixAsOrtho(0, 300, 0, 20, -1, 1);
    viewer().setSceneData(redShape({{250, 5, 0}, {300, 5, 0}, {300, 20, 0}, {250, 20, 0}}));
    frame(0);
    ASSERT_EQ(drawn->s(), 300);
    ASSERT_EQ(drawn->t(), 20);
    for (unsigned y = 0; y < 20; ++y)
        for (unsigned x = 0; x < 300; ++x)
            ASSERT_EQ(drawn->data(x, y)[0], x >= 250 && y >= 5 ? 255 : 0) << x << ", " << y;
}
