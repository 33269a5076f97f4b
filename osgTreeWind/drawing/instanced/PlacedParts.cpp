// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/PlacedParts.h>

#include <osgTreeWind/gpu/OsgConversions.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {

PlacedParts::PlacedParts(const ViewFrustum& view, const ImpostorProjection& projection,
                         const PlacedTree& tree, const glm::vec2& lean, float height)
    : _projection(projection), _foot(tree.position), _lean(lean, 0.0f), _axes(tree.scale.axes) {
    const glm::vec3& axes = _axes;
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    _toForest = glm::mat3(axes.x * glm::vec3(cosine, sine, 0.0f), axes.y * glm::vec3(-sine, cosine, 0.0f),
                          glm::vec3(0.0f, 0.0f, axes.z));
    const float sway = 1.5f * (std::abs(lean.x) + std::abs(lean.y)) + 0.02f * height;
    for (const osg::Vec4& plane : view) {
        const glm::vec3 normal(plane.x(), plane.y(), plane.z());
        _planes[_planeCount++] = {normal * _toForest, glm::dot(normal, _foot) + plane.w() + sway};
    }
    const osg::Matrixf& clip = projection.toClip();
    for (int axis = 0; axis < 3; ++axis) {
        const glm::vec3& way = _toForest[axis];
        const auto along = [&](int column) {
            return std::abs(way.x * clip(0, column) + way.y * clip(1, column) + way.z * clip(2, column));
        };
        _extents[static_cast<std::size_t>(axis)] = {along(0), along(1), along(3)};
    }
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
    const glm::vec3 extent = halfExtentOf(part), &box = part.halfExtent;
    const glm::vec3 half = extent.x * _extents[0] + extent.y * _extents[1] + extent.z * _extents[2];
    if (!(half.z < 0.25f * centre.w()))
        return false;
    const float nearest = 1.0f / (centre.w() - half.z), farthest = 1.0f / (centre.w() + half.z),
                perW = 1.0f / centre.w();
    for (int axis = 0; axis < 2; ++axis) {
        const float low = centre[axis] - half[axis], high = centre[axis] + half[axis];
        place.low[axis] = low * (low > 0.0f ? farthest : nearest);
        place.high[axis] = high * (high > 0.0f ? nearest : farthest);
        // In each direction, 0.7 sqrt(3) standard deviations of points that are evenly distributed in the
        // box.
        const float core = 0.7f * glm::length(glm::vec3(box.x * _extents[0][axis], box.y * _extents[1][axis],
                                                        box.z * _extents[2][axis]));
        place.coreLow[axis] = perW * (centre[axis] - core);
        place.coreHigh[axis] = perW * (centre[axis] + core);
    }
    // 1 m² at this distance, in clip space; the axes across and upward may be scaled differently.
    const float perArea =
        std::sqrt(
            (_extents[0].x * _extents[0].x + _extents[1].x * _extents[1].x + _extents[2].x * _extents[2].x) *
            (_extents[0].y * _extents[0].y + _extents[1].y * _extents[1].y + _extents[2].y * _extents[2].y)) *
        perW * perW;
    const osg::Vec2 core = place.coreHigh - place.coreLow;
    const float area = core.x() * core.y();
    place.coverage = area > 0.0f ? 1.0f - std::exp(-cover * part.area * perArea / area) : 0.0f;
    return true;
}

} // namespace osgTreeWind
