// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundTile.h>
#include <osgTreeWind/places/FunctionGround.h>

#include <gtest/gtest.h>
#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osgUtil/CullVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Optimizer>
#include <osgUtil/RenderStage>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr GroundArea kilometres{{-2000, -2000}, {2000, 2000}, 1.0};

double hills(double x, double y) {
    return 40.0 * std::sin(0.004 * x) * std::sin(0.005 * y) + 2.0 * std::sin(0.1 * x);
}

osg::ref_ptr<osg::Node> groundOf(const FunctionGround::Function& function,
                                 const GroundArea& area = kilometres) {
    return createGroundDrawing(std::make_shared<FunctionGround>(function, area), glm::dvec3(0.0),
                               osg::BoundingSphere(osg::Vec3(), 10.0f));
}

/// The meshes that a camera of 1000 x 1000 pixels draws when it looks north.
std::vector<const osg::Geometry*> seenFrom(osg::Node& ground, const osg::Vec3d& eye) {
    osg::ref_ptr<osgUtil::CullVisitor> visitor = new osgUtil::CullVisitor;
    const osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    const osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    osg::Matrix view;
    view.makeLookAt(eye, eye + osg::Vec3d(0, 10, -1), osg::Z_AXIS);
    visitor->setStateGraph(graph);
    visitor->setRenderStage(stage);
    visitor->pushViewport(new osg::Viewport(0, 0, 1000, 1000));
    visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrix::perspective(60, 1, 0.1, 10000)));
    visitor->pushModelViewMatrix(new osg::RefMatrix(view), osg::Transform::ABSOLUTE_RF);
    ground.accept(*visitor);
    std::vector<const osg::Geometry*> seen;
    const auto collect = [&](const osgUtil::StateGraph& from, const auto& self) -> void {
        for (const auto& leaf : from._leaves)
            seen.push_back(leaf->_drawable->asGeometry());
        for (const auto& child : from._children)
            self(*child.second, self);
    };
    collect(*graph, collect);
    return seen;
}

double spacingOf(const osg::Geometry& mesh) {
    const osg::BoundingBox box = mesh.getBoundingBox();
    return static_cast<double>(box.xMax() - box.xMin()) / 64.0;
}

} // namespace

TEST(GroundTile, IsFineNearTheCameraAndCoarseFarAway) {
    const osg::ref_ptr<osg::Node> ground = groundOf(hills);
    ASSERT_TRUE(ground);
    const osg::Vec3d eye(0, -1500, hills(0, -1500) + 2);
    const auto seen = seenFrom(*ground, eye);
    ASSERT_GT(seen.size(), 10u);
    EXPECT_LT(seen.size(), 400u);
    double finest = 1e9, coarsest = 0;
    std::size_t triangles = 0;
    for (const osg::Geometry* mesh : seen) {
        const osg::BoundingBox box = mesh->getBoundingBox();
        const double spacing = spacingOf(*mesh);
        finest = std::min(finest, spacing);
        coarsest = std::max(coarsest, spacing);
        triangles += mesh->getPrimitiveSet(0)->getNumIndices() / 3;
        const osg::Vec2d nearest(std::clamp<double>(eye.x(), box.xMin(), box.xMax()),
                                 std::clamp<double>(eye.y(), box.yMin(), box.yMax()));
        const double distance = (nearest - osg::Vec2d(eye.x(), eye.y())).length();
        EXPECT_LT(spacing / (distance + 60.0) * 866.0, 16.0) << "pixels, " << distance << " m away";
    }
    EXPECT_NEAR(finest, 0.5, 1e-3);
    EXPECT_GT(coarsest, 5.0);
    EXPECT_LT(triangles, 1000000u);
    RecordProperty("triangles", static_cast<int>(triangles));
}

TEST(GroundTile, HasNoGapsBetweenLevels) {
    // Vertical rays hit the drawn meshes everywhere, including borders between levels.
    const osg::ref_ptr<osg::Node> ground = groundOf(hills);
    osg::ref_ptr<osg::Group> drawn = new osg::Group;
    for (const osg::Geometry* mesh : seenFrom(*ground, {0, -1500, hills(0, -1500) + 2}))
        drawn->addChild(const_cast<osg::Geometry*>(mesh));
    for (int i = 0; i < 300; ++i) {
        const double y = -1400.0 + 3200.0 * i / 300.0, x = (y + 1500.0) * 0.5 * std::sin(1.7 * i);
        osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(x, y, 500), osg::Vec3d(x, y, -500));
        osgUtil::IntersectionVisitor visitor(ray);
        drawn->accept(visitor);
        ASSERT_TRUE(ray->containsIntersections()) << x << ", " << y;
        EXPECT_NEAR(ray->getFirstIntersection().getWorldIntersectPoint().z(), hills(x, y), 1.0);
    }
}

TEST(GroundTile, IsPickedAtTheFinestLevel) {
    const osg::ref_ptr<osg::Node> ground = groundOf(hills);
    for (const osg::Vec2d& place :
         {osg::Vec2d(0, 0), osg::Vec2d(1234.5, -777.7), osg::Vec2d(-1999.9, 1999.9)}) {
        osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(place, 500), osg::Vec3d(place, -500));
        osgUtil::IntersectionVisitor visitor(ray);
        ground->accept(visitor);
        ASSERT_TRUE(ray->containsIntersections());
        EXPECT_NEAR(ray->getFirstIntersection().getWorldIntersectPoint().z(), hills(place.x(), place.y()),
                    0.02);
    }
    osg::ref_ptr<osgUtil::LineSegmentIntersector> beyond =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(2001, 0, 500), osg::Vec3d(2001, 0, -500));
    osgUtil::IntersectionVisitor visitor(beyond);
    ground->accept(visitor);
    EXPECT_FALSE(beyond->containsIntersections());
}

TEST(GroundTile, OptimizerKeepsTheTransformAbove) {
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const osg::ref_ptr<osg::MatrixTransform> transform =
        new osg::MatrixTransform(osg::Matrix::translate(10000, 0, 50));
    transform->setDataVariance(osg::Object::STATIC);
    transform->addChild(groundOf(hills));
    scene->addChild(transform);
    osgUtil::Optimizer().optimize(scene, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS |
                                             osgUtil::Optimizer::FLATTEN_STATIC_TRANSFORMS);
    osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(10300, 400, 500), osg::Vec3d(10300, 400, -500));
    osgUtil::IntersectionVisitor visitor(ray);
    scene->accept(visitor);
    ASSERT_TRUE(ray->containsIntersections());
    EXPECT_NEAR(ray->getFirstIntersection().getWorldIntersectPoint().z(), 50.0 + hills(300, 400), 0.02);
}

TEST(GroundTile, HasBoundsBeforeTheFirstCull) {
    const osg::ref_ptr<osg::Node> ground = groundOf(hills);
    osg::ComputeBoundsVisitor bounds;
    ground->accept(bounds);
    EXPECT_NEAR(bounds.getBoundingBox().xMin(), -2000, 1);
    EXPECT_NEAR(bounds.getBoundingBox().yMax(), 2000, 1);
    EXPECT_NEAR(bounds.getBoundingBox().zMax(), 41, 3);
    EXPECT_GT(ground->getBound().radius(), 2800.0f);
}

TEST(GroundTile, IsNullWithoutGround) {
    EXPECT_FALSE(createGroundDrawing(nullptr, glm::dvec3(0.0), osg::BoundingSphere()));
    EXPECT_FALSE(groundOf([](double, double) { return std::nan(""); }));
    EXPECT_FALSE(groundOf(hills, {{1e6, 1e6}, {1.1e6, 1.1e6}, 1.0})) << "farther than 50 km";
    EXPECT_TRUE(groundOf(hills, GroundArea())) << "an unbounded function";
}

} // namespace osgTreeWind
