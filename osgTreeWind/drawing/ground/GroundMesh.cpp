// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundMesh.h>

#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr int across = groundSquares + 1; // vertices

/// Heights at the vertices of a mesh and one more row around them for the normals.
class Samples {
public:
    Samples(const DrawnGround& drawn, const glm::dvec2& corner, double spacing) {
        for (int j = -1; j <= across; ++j)
            for (int i = -1; i <= across; ++i) {
                const double x = std::clamp(corner.x + i * spacing, drawn.low.x, drawn.high.x),
                             y = std::clamp(corner.y + j * spacing, drawn.low.y, drawn.high.y);
                const double z =
                    heightOf(*drawn.ground, {x, y}).value_or(std::numeric_limits<double>::quiet_NaN());
                _points.emplace_back(static_cast<float>(x - drawn.origin.x),
                                     static_cast<float>(y - drawn.origin.y),
                                     static_cast<float>(z - drawn.origin.z));
            }
    }

    const osg::Vec3& at(int i, int j) const {
        return _points[static_cast<std::size_t>((j + 1) * (across + 2) + i + 1)];
    }
    bool hasGround(int i, int j) const { return !std::isnan(at(i, j).z()); }

    osg::Vec3 normal(int i, int j) const {
        osg::Vec3 up(-slope(i, j, 1, 0), -slope(i, j, 0, 1), 1.0f);
        up.normalize();
        return up;
    }
    bool isEmpty() const {
        return std::all_of(_points.begin(), _points.end(),
                           [](const osg::Vec3& point) { return std::isnan(point.z()); });
    }

private:
    /// Slope between the neighbours with ground.
    float slope(int i, int j, int di, int dj) const {
        const osg::Vec3 &here = at(i, j), &before = hasGround(i - di, j - dj) ? at(i - di, j - dj) : here,
                        &after = hasGround(i + di, j + dj) ? at(i + di, j + dj) : here;
        const osg::Vec3 way = after - before;
        const float run = way.x() + way.y();
        return run > 0.0f ? way.z() / run : 0.0f;
    }

    std::vector<osg::Vec3> _points;
};

/// Builds the geometry of a mesh.
class Builder {
public:
    Builder(const Samples& samples, double spacing)
        : _samples(samples), _spacing(static_cast<float>(spacing)), _index(across * across, none) {}

    osg::ref_ptr<osg::Geometry> build() {
        for (int j = 0; j < groundSquares; ++j)
            for (int i = 0; i < groundSquares; ++i)
                addSquare(i, j);
        for (int k = 0; k < groundSquares; ++k) { // counter-clockwise
            addSkirt(k, 0, k + 1, 0, 0, -1);
            addSkirt(groundSquares, k, groundSquares, k + 1, 1, 0);
            addSkirt(k + 1, groundSquares, k, groundSquares, 0, 1);
            addSkirt(0, k + 1, 0, k, -1, 0);
        }
        osg::ref_ptr<osg::Geometry> geometry = new SceneGeometry(sharedProgram("ground", "color"));
        geometry->setVertexArray(_vertices);
        geometry->setNormalArray(_normals, osg::Array::BIND_PER_VERTEX);
        geometry->setTexCoordArray(0, _places);
        geometry->addPrimitiveSet(_triangles);
        return geometry;
    }

private:
    static constexpr GLushort none = 0xffff;

    GLushort add(const osg::Vec3& vertex, const osg::Vec3& normal) {
        _vertices->push_back(vertex);
        _normals->push_back(normal);
        _places->push_back({vertex.x(), vertex.y()});
        return static_cast<GLushort>(_vertices->size() - 1);
    }
    GLushort vertex(int i, int j) {
        GLushort& index = _index[static_cast<std::size_t>(j * across + i)];
        if (index == none)
            index = add(_samples.at(i, j), _samples.normal(i, j));
        return index;
    }
    void addSquare(int i, int j) {
        const osg::Vec3 extent = _samples.at(i + 1, j + 1) - _samples.at(i, j);
        if (!(extent.x() > 0.0f && extent.y() > 0.0f)) // outside the part to draw
            return;
        std::array<GLushort, 4> corners{};
        std::size_t count = 0;
        for (const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            if (_samples.hasGround(i + u, j + v))
                corners[count++] = vertex(i + u, j + v);
        if (count < 3)
            return;
        addTriangle(corners[0], corners[1], corners[2]);
        if (count == 4)
            addTriangle(corners[0], corners[2], corners[3]);
    }
    void addTriangle(GLushort a, GLushort b, GLushort c) {
        for (const GLushort corner : {a, b, c})
            _triangles->push_back(corner);
    }
    /// Adds a vertical skirt below an edge with a neighbour, which hides gaps between different spacings.
    void addSkirt(int i0, int j0, int i1, int j1, int outX, int outY) {
        const auto isInner = [&](int i, int j) {
            const osg::Vec3 out = _samples.at(i + outX, j + outY) - _samples.at(i, j);
            return _samples.hasGround(i, j) && (out.x() != 0.0f || out.y() != 0.0f);
        };
        if (!isInner(i0, j0) || !isInner(i1, j1))
            return;
        const osg::Vec3 &start = _samples.at(i0, j0), &end = _samples.at(i1, j1);
        const osg::Vec3 down(0.0f, 0.0f, -(2.0f * _spacing + 2.0f * std::abs(end.z() - start.z())));
        const GLushort a = vertex(i0, j0), b = vertex(i1, j1);
        const GLushort c = add(start + down, _samples.normal(i0, j0)),
                       d = add(end + down, _samples.normal(i1, j1));
        addTriangle(a, c, d);
        addTriangle(a, d, b);
    }

    const Samples& _samples;
    float _spacing;
    std::vector<GLushort> _index; ///< By sample: index of its vertex.
    osg::ref_ptr<osg::Vec3Array> _vertices = new osg::Vec3Array, _normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> _places = new osg::Vec2Array;
    osg::ref_ptr<osg::DrawElementsUShort> _triangles = new osg::DrawElementsUShort(GL_TRIANGLES);
};

/// @param quarter 1: east, 2: north.
osg::BoundingBox boxOf(const Samples& samples, int quarter, double spacing) {
    const int half = groundSquares / 2, i0 = quarter & 1 ? half : 0, j0 = quarter & 2 ? half : 0;
    osg::BoundingBox box;
    for (int j = j0; j <= j0 + half; ++j)
        for (int i = i0; i <= i0 + half; ++i)
            if (samples.hasGround(i, j))
                box.expandBy(samples.at(i, j));
    if (!box.valid())
        return box;
    const float margin = 4.0f * static_cast<float>(spacing);
    // The edge of a hole may lie between vertices, so the box covers the whole quarter.
    box.expandBy(osg::Vec3(samples.at(i0, j0).x(), samples.at(i0, j0).y(), box.zMin() - margin));
    box.expandBy(osg::Vec3(samples.at(i0 + half, j0 + half).x(), samples.at(i0 + half, j0 + half).y(),
                           box.zMax() + margin));
    return box;
}

} // namespace

GroundMesh::GroundMesh(const DrawnGround& drawn, const glm::dvec2& corner, double spacing) {
    const Samples samples(drawn, corner, spacing);
    geometry = Builder(samples, spacing).build();
    for (int quarter = 0; quarter < 4; ++quarter)
        quarters[static_cast<std::size_t>(quarter)] = boxOf(samples, quarter, spacing);
}

} // namespace osgTreeWind
