// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundMesh.h>
#include <osgTreeWind/places/FunctionGround.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {
namespace {

DrawnGround drawnOf(const FunctionGround::Function& function, const glm::dvec2& high = {64, 64}) {
    return {std::make_shared<FunctionGround>(function), {1000.0, 2000.0, 100.0}, {0, 0}, high};
}

const osg::Vec3Array& verticesOf(const GroundMesh& mesh) {
    return static_cast<const osg::Vec3Array&>(*mesh.geometry->getVertexArray());
}
unsigned trianglesOf(const GroundMesh& mesh) {
    return mesh.geometry->getPrimitiveSet(0)->getNumIndices() / 3;
}

double wave(double x, double y) {
    return 5.0 * std::sin(0.1 * x) * std::cos(0.2 * y);
}

} // namespace

TEST(GroundMesh, FollowsTheGroundInTheForestsFrame) {
    const GroundMesh mesh(drawnOf(wave), {0, 0}, 1.0);
    EXPECT_EQ(verticesOf(mesh).size(), 65u * 65u) << "without neighbours there is no skirt";
    EXPECT_EQ(trianglesOf(mesh), 64u * 64u * 2u);
    for (const osg::Vec3& vertex : verticesOf(mesh))
        EXPECT_NEAR(vertex.z() + 100.0, wave(vertex.x() + 1000.0, vertex.y() + 2000.0), 1e-3);
}

TEST(GroundMesh, HasNormalsOfTheSlopeAndCoordinatesInMetres) {
    const GroundMesh mesh(drawnOf([](double x, double y) { return 0.5 * x - 0.25 * y; }), {0, 0}, 1.0);
    osg::Vec3 up(-0.5f, 0.25f, 1.0f);
    up.normalize();
    const auto& normals = static_cast<const osg::Vec3Array&>(*mesh.geometry->getNormalArray());
    const auto& places = static_cast<const osg::Vec2Array&>(*mesh.geometry->getTexCoordArray(0));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        EXPECT_LT((normals[i] - up).length(), 1e-4f);
        EXPECT_EQ(places[i], osg::Vec2(verticesOf(mesh)[i].x(), verticesOf(mesh)[i].y())) << "metres";
    }
}

TEST(GroundMesh, HasSkirtsNextToNeighbours) {
    const GroundMesh mesh(drawnOf(wave, {64, 640}), {0, 0}, 1.0);
    EXPECT_EQ(trianglesOf(mesh), 64u * 64u * 2u + 64u * 2u) << "a skirt in the north";
    EXPECT_EQ(trianglesOf(GroundMesh(drawnOf(wave, {640, 640}), {128, 128}, 1.0)),
              64u * 64u * 2u + 4u * 64u * 2u);
}

TEST(GroundMesh, IsClippedToThePartToDraw) {
    const GroundMesh mesh(drawnOf(wave, {10.5, 20}), {0, 0}, 1.0);
    EXPECT_EQ(trianglesOf(mesh), 11u * 20u * 2u);
    float east = -1e9f;
    for (const osg::Vec3& vertex : verticesOf(mesh))
        east = std::max(east, vertex.x());
    EXPECT_FLOAT_EQ(east, -989.5f);
}

TEST(GroundMesh, HasNoTrianglesOverHoles) {
    const GroundMesh mesh(drawnOf([](double x, double y) { return x == 30 && y == 30 ? std::nan("") : 1.0; }),
                          {0, 0}, 1.0);
    EXPECT_EQ(trianglesOf(mesh), 64u * 64u * 2u - 4u) << "half of each of the four squares around the hole";
    for (const osg::Vec3& vertex : verticesOf(mesh))
        EXPECT_TRUE(vertex.valid());
    const GroundMesh nothing(drawnOf([](double, double) { return std::nan(""); }), {0, 0}, 1.0);
    EXPECT_EQ(trianglesOf(nothing), 0u);
    for (const osg::BoundingBox& quarter : nothing.quarters)
        EXPECT_FALSE(quarter.valid());
}

} // namespace osgTreeWind
