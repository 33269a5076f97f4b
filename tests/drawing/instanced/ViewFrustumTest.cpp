// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// A camera of 600 x 400 pixels at the origin that looks north, with a vertical field of view of 60 degrees.
class ViewFrustumTest : public ::testing::Test {
protected:
    ViewFrustumTest() : visitor(new osgUtil::CullVisitor) {
        visitor->pushViewport(new osg::Viewport(0, 0, 600, 400));
        visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrix::perspective(60.0, 1.5, 1.0, 1000.0)));
    }
    /// @param toView transform of the culled node.
    ViewFrustum view(const osg::Matrix& toView = osg::Matrix()) {
        const osg::Matrix north = osg::Matrix::lookAt(osg::Vec3d(), osg::Vec3d(0, 1, 0), osg::Vec3d(0, 0, 1));
        visitor->pushModelViewMatrix(new osg::RefMatrix(toView * north), osg::Transform::ABSOLUTE_RF);
        const ViewFrustum view(*visitor);
        visitor->popModelViewMatrix();
        return view;
    }
    static osg::BoundingBox boxAt(const osg::Vec3& centre, float half) {
        return {centre - osg::Vec3(half, half, half), centre + osg::Vec3(half, half, half)};
    }
    osg::ref_ptr<osgUtil::CullVisitor> visitor;
};

const double focal = 200.0 / std::tan(osg::PI / 6.0); // pixels

} // namespace

TEST_F(ViewFrustumTest, ComputesTheHeightInPixels) {
    const ViewFrustum here = view();
    EXPECT_NEAR(here.pixels(osg::Vec3(0, 50, 0), 10.0f), focal * 10.0 / 50.0, 0.1);
    EXPECT_NEAR(here.pixels(osg::Vec3(20, 50, 5), 10.0f), focal * 10.0 / 50.0, 0.1)
        << "the depth counts, not the distance";
    EXPECT_GT(here.pixels(osg::Vec3(0, 0, 0), 10.0f), 1e5f) << "at the eye";
    EXPECT_TRUE(std::isfinite(here.pixels(osg::Vec3(0, 0, 0), 10.0f)));
}

TEST_F(ViewFrustumTest, ScaledNodeHasLargerTrees) {
    EXPECT_NEAR(view(osg::Matrix::scale(3.0, 3.0, 3.0)).pixels(osg::Vec3(0, 50, 0), 10.0f),
                focal * 30.0 / 150.0, 0.1);
}

TEST_F(ViewFrustumTest, LodScaleReducesPixels) {
    visitor->setLODScale(2.0f);
    EXPECT_NEAR(view().pixels(osg::Vec3(0, 50, 0), 10.0f), 0.5 * focal * 10.0 / 50.0, 0.1);
}

TEST_F(ViewFrustumTest, ClassifiesBoxesAndCapsules) {
    const ViewFrustum here = view();
    EXPECT_EQ(here.classify(boxAt({0, 50, 0}, 3)), ViewFrustum::Inside);
    EXPECT_EQ(here.classify(boxAt({0, -50, 0}, 3)), ViewFrustum::Outside);
    EXPECT_EQ(here.classify(boxAt({0, 50, 28.9f}, 3)), ViewFrustum::Across);
    EXPECT_EQ(here.classify(boxAt({0, 50, 40}, 3)), ViewFrustum::Outside);
    EXPECT_TRUE(here.intersects({0, 50, 30}, {0, 50, 30}, 2));
    EXPECT_FALSE(here.intersects({0, 50, 40}, {0, 50, 60}, 2));
    EXPECT_TRUE(here.intersects({0, 50, 40}, {0, 50, 60}, 20));
    EXPECT_TRUE(here.intersects({0, 50, 20}, {0, 50, 60}, 2));
    const float side = std::tan(osg::PI / 6.0) * 1.5f * 50.0f; // half the width of the view at 50 m
    EXPECT_FALSE(here.intersects({side + 5, 50, -10}, {side + 5, 50, 10}, 3)) << "a tree beside it";
}

TEST_F(ViewFrustumTest, UsesTheCoordinatesOfTheNode) {
    const ViewFrustum turned = view(osg::Matrix::rotate(osg::PI_2, osg::Z_AXIS)); // the node's +x is north
    EXPECT_EQ(turned.classify(boxAt({50, 0, 0}, 3)), ViewFrustum::Inside);
    EXPECT_EQ(turned.classify(boxAt({0, 50, 0}, 3)), ViewFrustum::Outside);
}

TEST_F(ViewFrustumTest, WithoutCullingEverythingIsVisible) {
    visitor->setCullingMode(osg::CullSettings::NO_CULLING);
    EXPECT_EQ(view().classify(boxAt({0, -50, 0}, 3)), ViewFrustum::Inside);
    EXPECT_TRUE(view().intersects({0, -500, 0}, {0, -500, 9}, 1));
}
