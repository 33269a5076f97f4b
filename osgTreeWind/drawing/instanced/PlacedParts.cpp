// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/PlacedParts.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/gpu/OsgConversions.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {

PlacedParts::PlacedParts(const ViewFrustum& view, const ImpostorProjection& projection,
                         const PlacedTree& tree, const glm::vec2& lean, float height)
    : _projection(projection), _foot(tree.position), _lean(lean, 0.0f), _axes(tree.scale.axes) {
    const glm::vec3& axes = _axes;
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    _toForest = glm::mat3(axes.x * glm::vec3(cosine, sine, 0.0f), axes.y * glm::vec3(-sine, cosine, 0.0f),
                          glm::vec3(0.0f, 0.0f, axes.z));
    const float sway = 1.5f * (std::abs(lean.x) + std::abs(lean.y)) + 0.02f * height;
    for (const osg::Vec4& plane : view) {
        const glm::vec3 normal(plane.x(), plane.y(), plane.z());
        _planes[_planeCount++] = {normal * _toForest, glm::dot(normal, _foot) + plane.w() + sway};
    }
    const osg::Matrixf& clip = projection.toClip();
    constexpr int columns[] = {0, 1, 3};
    for (std::size_t i = 0; i < _extents.size(); ++i) {
        const int column = columns[i];
        _extents[i] = glm::abs(glm::vec3(clip(0, column), clip(1, column), clip(2, column)) * _toForest);
    }
    _squareMetre = std::sqrt(glm::dot(_extents[0], _extents[0]) * glm::dot(_extents[1], _extents[1]));
}

glm::vec3 PlacedParts::halfExtentOf(const MeshPart& part) const {
    return part.halfExtent + part.reach * _beyond;
}

bool PlacedParts::isInView(const MeshPart& part) const {
    const glm::vec3 half = halfExtentOf(part);
    for (std::size_t i = 0; i < _planeCount; ++i)
        if (glm::dot(_planes[i].normal, part.centre) + glm::dot(glm::abs(_planes[i].normal), half) <
            -_planes[i].offset)
            return false;
    return true;
}

glm::vec3 PlacedParts::centreOf(const MeshPart& part) const {
    return _toForest * part.centre + _foot + part.rise * _lean;
}

float PlacedParts::distance(const MeshPart& part) const {
    return _projection.distance(toOsg(centreOf(part))) - glm::length(_axes * halfExtentOf(part));
}

bool PlacedParts::project(const MeshPart& part, float cover, OcclusionBuffer::Rectangle& place) const {
    const osg::Vec4 centre = osg::Vec4(toOsg(centreOf(part)), 1.0f) * _projection.toClip();
    const glm::vec3 extent = halfExtentOf(part);
    const float depth = glm::dot(_extents[2], extent);
    if (!(depth < 0.25f * centre.w()))
        return false;
    const float nearest = 1.0f / (centre.w() - depth), farthest = 1.0f / (centre.w() + depth),
                perW = 1.0f / centre.w();
    for (int axis = 0; axis < 2; ++axis) {
        const glm::vec3& along = _extents[static_cast<std::size_t>(axis)];
        const float half = glm::dot(along, extent), low = centre[axis] - half, high = centre[axis] + half;
        place.low[axis] = low * (low > 0.0f ? farthest : nearest);
        place.high[axis] = high * (high > 0.0f ? nearest : farthest);
        // In each direction, 0.7 sqrt(3) standard deviations of points that are evenly distributed in the
        // box.
        const float core = 0.7f * glm::length(along * part.halfExtent);
        place.coreLow[axis] = perW * (centre[axis] - core);
        place.coreHigh[axis] = perW * (centre[axis] + core);
    }
    const osg::Vec2 core = place.coreHigh - place.coreLow;
    const float area = core.x() * core.y();
    place.coverage =
        area > 0.0f ? 1.0f - math::exp(-cover * part.area * _squareMetre * perW * perW / area) : 0.0f;
    return true;
}

} // namespace osgTreeWind
