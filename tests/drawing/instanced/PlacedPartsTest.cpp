// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/PlacedParts.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr float placedHeight = 8.0f;
const osg::Vec3d up(0.0, 0.0, 1.0);

/// A part with some points whose box it has: where a branch is, and what it bears there, unscaled.
struct Sample {
    struct Point {
        glm::vec3 anchor, borne;
    };
    std::vector<Point> points;
    MeshPart part;
};

/// @param center of the part. @param size half the side of the box of its anchors, metres.
Sample makeSample(const glm::vec3& center, float size, float reach, std::mt19937& random) {
    std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
    Sample sample;
    const glm::vec3 outward(anywhere(random), anywhere(random), anywhere(random)); // as at the end of a shoot
    glm::vec3 low(1e30f), high(-1e30f);
    for (int i = 0; i < 30; ++i) {
        const glm::vec3 anchor =
            center + size * glm::vec3(anywhere(random), anywhere(random), anywhere(random));
        const glm::vec3 way = outward + glm::vec3(anywhere(random), anywhere(random), anywhere(random));
        const glm::vec3 borne = reach * way / std::max(glm::length(way), 1.0f);
        sample.points.push_back({anchor, borne});
        low = glm::min(low, anchor + borne);
        high = glm::max(high, anchor + borne);
    }
    sample.part.centre = 0.5f * (low + high);
    sample.part.halfExtent = 0.5f * (high - low);
    sample.part.reach = reach;
    sample.part.rise = std::pow(glm::clamp(sample.part.centre.z / placedHeight, 0.0f, 1.0f), leanPower);
    sample.part.area = size * size;
    return sample;
}

struct Camera {
    osg::Matrix view, projection;
};

/// Cameras at and in a tree of 8 m at the origin: level, pitched up and down, rolled, parallel.
std::vector<Camera> cameras() {
    const osg::Matrix wide = osg::Matrix::perspective(70.0, 1.5, 0.1, 1000.0),
                      parallel = osg::Matrix::ortho(-5.0, 5.0, -3.0, 3.0, 0.1, 100.0);
    std::vector<Camera> all;
    for (const osg::Vec3d& eye : {osg::Vec3d(0, -12, 2), osg::Vec3d(9, 3, 1), osg::Vec3d(-4, 4, 20),
                                  osg::Vec3d(1, -1, 3), osg::Vec3d(0, -300, 30)})
        for (const osg::Vec3d& at : {osg::Vec3d(0, 0, 4), osg::Vec3d(3, 0, 8), osg::Vec3d(-3, 2, 0)})
            for (const double roll : {0.0, 0.5, 3.0})
                for (const osg::Matrix& projection : {wide, parallel})
                    all.push_back({osg::Matrix::lookAt(eye, at, up) * osg::Matrix::rotate(roll, osg::Z_AXIS),
                                   projection});
    return all;
}

/// A view of a tree with the given scales.
class View {
public:
    View(const Camera& camera, const PlacedTree& tree, const glm::vec2& lean = {})
        : _visitor(visitorOf(camera)), _frustum(*_visitor), _projection(*_visitor),
          parts(_frustum, _projection, tree, lean, placedHeight) {}
    float distance(const glm::vec3& point) const { return _projection.distance(toOsg(point)); }
    osg::Vec4 toClip(const glm::vec3& point) const {
        return osg::Vec4(toOsg(point), 1.0f) * _projection.toClip();
    }

private:
    static osg::ref_ptr<osgUtil::CullVisitor> visitorOf(const Camera& camera) {
        osg::ref_ptr<osgUtil::CullVisitor> visitor = new osgUtil::CullVisitor;
        visitor->pushViewport(new osg::Viewport(0, 0, 600, 400));
        visitor->pushProjectionMatrix(new osg::RefMatrix(camera.projection));
        visitor->pushModelViewMatrix(new osg::RefMatrix(camera.view), osg::Transform::ABSOLUTE_RF);
        return visitor;
    }
    osg::ref_ptr<osgUtil::CullVisitor> _visitor;
    ViewFrustum _frustum;
    ImpostorProjection _projection;

public:
    PlacedParts parts;
};

/// Trees of different headings and scales.
std::vector<PlacedTree> trees() {
    std::vector<PlacedTree> all;
    for (const float heading : {0.0f, 0.9f, 4.0f})
        for (const TreeScale& scale :
             {TreeScale(), TreeScale{{1.3f, 1.3f, 0.8f}, 1.0f, 1.0f},
              TreeScale{{0.7f, 0.7f, 1.1f}, 1.5f, 1.4f}, TreeScale{{1.2f, 1.2f, 1.2f}, 0.6f, 0.6f}}) {
            PlacedTree tree;
            tree.scale = scale;
            tree.heading = heading;
            tree.position = {0.2f, -0.3f, 0.1f};
            all.push_back(tree);
        }
    return all;
}

/// Where a point of a swaying tree is, as shaders/instance.glsl turns and scales it.
glm::vec3 placeOf(const Sample::Point& point, const PlacedTree& tree, const glm::vec3& sway) {
    const glm::vec3 at = tree.scale.axes * point.anchor + tree.scale.leaf * point.borne;
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    return tree.position + glm::vec3(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y, at.z) + sway;
}

/// Calls visit(view, tree, sample, lean) for samples of trees in views.
void forEachSample(
    const std::function<void(View&, const PlacedTree&, const Sample&, const glm::vec2& lean)>& visit) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
    for (const Camera& camera : cameras())
        for (const PlacedTree& tree : trees()) {
            const glm::vec2 lean(anywhere(random), anywhere(random));
            View view(camera, tree, lean);
            view.parts.setReachScale(tree.scale.leaf);
            for (int i = 0; i < 20; ++i)
                visit(view, tree,
                      makeSample(
                          {3.0f * anywhere(random), 3.0f * anywhere(random), 4.0f + 4.0f * anywhere(random)},
                          0.1f + 0.3f * float(i % 3), 0.6f * float(i % 2), random),
                      lean);
        }
}

} // namespace

TEST(PlacedPartsTest, BoundsOnTheScreenContainAllPoints) {
    int projected = 0;
    forEachSample([&](View& view, const PlacedTree& tree, const Sample& sample, const glm::vec2& lean) {
        OcclusionBuffer::Rectangle place;
        if (!view.parts.project(sample.part, 1.0f, place))
            return;
        ++projected;
        const glm::vec3 sway = sample.part.rise * glm::vec3(lean, 0.0f);
        for (const Sample::Point& point : sample.points) {
            const osg::Vec4 clip = view.toClip(placeOf(point, tree, sway));
            ASSERT_GT(clip.w(), 0.0f);
            for (int axis = 0; axis < 2; ++axis) {
                const float at = clip[axis] / clip.w();
                ASSERT_GE(at, place.low[axis] - 1e-4f);
                ASSERT_LE(at, place.high[axis] + 1e-4f);
            }
        }
        for (int axis = 0; axis < 2; ++axis) {
            ASSERT_GT(place.coreLow[axis], place.low[axis]);
            ASSERT_LT(place.coreHigh[axis], place.high[axis]);
        }
    });
    EXPECT_GT(projected, 10000);
}

TEST(PlacedPartsTest, BoundsOfASmallPartAreThoseOfItsCorners) {
    int projected = 0;
    for (const Camera& camera : cameras())
        for (const PlacedTree& tree : trees()) {
            const View view(camera, tree);
            MeshPart part;
            part.centre = {1.0f, 0.5f, 5.0f};
            part.halfExtent = {0.01f, 0.02f, 0.03f};
            OcclusionBuffer::Rectangle place;
            if (!view.parts.project(part, 1.0f, place))
                continue; // behind the eye
            ++projected;
            osg::Vec2 low(1e9f, 1e9f), high = -low;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                const osg::Vec4 clip =
                    view.toClip(placeOf({part.centre + side * part.halfExtent, {}}, tree, {}));
                for (int axis = 0; axis < 2; ++axis) {
                    low[axis] = std::min(low[axis], clip[axis] / clip.w());
                    high[axis] = std::max(high[axis], clip[axis] / clip.w());
                }
            }
            for (int axis = 0; axis < 2; ++axis) {
                const float size = high[axis] - low[axis];
                if (std::abs(low[axis]) > 1.0f)
                    continue;
                EXPECT_NEAR(place.low[axis], low[axis], size);
                EXPECT_NEAR(place.high[axis], high[axis], size);
            }
        }
    EXPECT_GT(projected, 500);
}

TEST(PlacedPartsTest, APartWithAPointInViewIsInView) {
    int seen = 0, culled = 0;
    forEachSample([&](View& view, const PlacedTree& tree, const Sample& sample, const glm::vec2& lean) {
        bool shows = false;
        for (const Sample::Point& point : sample.points) {
            const osg::Vec4 clip = view.toClip(placeOf(point, tree, glm::vec3(lean, 0.0f)));
            shows = shows || (clip.w() > 0.0f && std::abs(clip.x()) < clip.w() &&
                              std::abs(clip.y()) < clip.w() && std::abs(clip.z()) < clip.w());
        }
        ASSERT_TRUE(!shows || view.parts.isInView(sample.part)) << "it sways as far as the treetop";
        seen += shows;
        culled += !view.parts.isInView(sample.part);
    });
    EXPECT_GT(seen, 5000);
    EXPECT_GT(culled, 1000);
}

TEST(PlacedPartsTest, DistanceIsToTheNearestPoint) {
    forEachSample([](View& view, const PlacedTree& tree, const Sample& sample, const glm::vec2& lean) {
        const glm::vec3 sway = sample.part.rise * glm::vec3(lean, 0.0f);
        for (const Sample::Point& point : sample.points)
            ASSERT_LE(view.parts.distance(sample.part), view.distance(placeOf(point, tree, sway)) + 1e-3f);
    });
}

TEST(PlacedPartsTest, APartAroundOrBehindTheEyeIsNotProjected) {
    const Camera camera{osg::Matrix::lookAt(osg::Vec3d(0, -1, 4), osg::Vec3d(0, 9, 4), up),
                        osg::Matrix::perspective(70.0, 1.5, 0.1, 1000.0)};
    const View view(camera, PlacedTree());
    OcclusionBuffer::Rectangle place;
    MeshPart part;
    part.halfExtent = glm::vec3(0.5f);
    for (const float y : {-20.0f, -1.5f, -1.0f, -0.5f}) {
        part.centre = {0.0f, y, 4.0f};
        EXPECT_FALSE(view.parts.project(part, 1.0f, place)) << y;
    }
    part.centre.y = 3.0f;
    EXPECT_TRUE(view.parts.project(part, 1.0f, place));
}

TEST(PlacedPartsTest, CoverageFollowsFromTheAreaOfThePart) {
    const auto coverage = [](float distance, float area, float cover, const TreeScale& scale = {}) {
        const Camera camera{osg::Matrix::lookAt(osg::Vec3d(0, -distance, 0), osg::Vec3d(), up),
                            osg::Matrix::perspective(40.0, 1.5, 0.1, 1000.0)};
        PlacedTree tree;
        tree.scale = scale;
        const View view(camera, tree);
        MeshPart part;
        part.halfExtent = glm::vec3(0.5f);
        part.area = area;
        OcclusionBuffer::Rectangle place;
        EXPECT_TRUE(view.parts.project(part, cover, place));
        return place.coverage;
    };
    // The core of a box of 1 m is 0.7 m wide.
    EXPECT_NEAR(coverage(50.0f, 0.1f, 1.0f), 1.0f - std::exp(-0.1f / 0.49f), 0.005f);
    EXPECT_NEAR(coverage(50.0f, 0.1f, 2.0f), 1.0f - std::exp(-0.2f / 0.49f), 0.005f);
    EXPECT_NEAR(coverage(20.0f, 0.3f, 1.0f), coverage(200.0f, 0.3f, 1.0f), 0.005f)
        << "the same at any distance";
    EXPECT_NEAR(coverage(50.0f, 0.1f, 1.0f, TreeScale{glm::vec3(2.0f), 1.0f, 1.0f}),
                1.0f - std::exp(-0.1f / 0.49f), 0.005f);
    EXPECT_EQ(coverage(50.0f, 0.0f, 1.0f), 0.0f);
}
