// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ImpostorProjection.h>

#include <osgTreeWind/base/PortableMath.h>

#include <osg/Math>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// @return false if the point is behind the eye.
bool projectPoint(const osg::Matrixf& toClip, const osg::Vec3& point, osg::Vec2& screen) {
    const osg::Vec4 clip = osg::Vec4(point, 1.0f) * toClip;
    if (!(clip.w() > 1.0e-3f))
        return false;
    screen.set(clip.x() / clip.w(), clip.y() / clip.w());
    return true;
}

} // namespace

ImpostorProjection::ImpostorProjection(osgUtil::CullVisitor& visitor)
    : _toClip(*visitor.getModelViewMatrix() * *visitor.getProjectionMatrix()),
      _eye(visitor.getViewPointLocal()) {
    if ((*visitor.getProjectionMatrix())(3, 3) < 0.5)
        return;
    const osg::Matrix& toEye = *visitor.getModelViewMatrix();
    _parallelDirection.set(static_cast<float>(toEye(0, 2)), static_cast<float>(toEye(1, 2)),
                           static_cast<float>(toEye(2, 2)));
    _parallelDirection.normalize();
}

bool ImpostorProjection::project(const osg::BoundingBox& box, osg::Vec2& low, osg::Vec2& high) const {
    for (unsigned i = 0; i < 8; ++i) {
        osg::Vec2 corner;
        if (!projectPoint(_toClip, box.corner(i), corner))
            return false;
        low = i == 0 ? corner : osg::Vec2(std::min(low.x(), corner.x()), std::min(low.y(), corner.y()));
        high = i == 0 ? corner : osg::Vec2(std::max(high.x(), corner.x()), std::max(high.y(), corner.y()));
    }
    return true;
}

OcclusionBuffer::Billboard ImpostorProjection::project(const PlacedTree& tree, const glm::vec2& lean,
                                                       const ImpostorStrip& impostor) const {
    const ImpostorPictures& pictures = impostor.pictures();
    const osg::Vec3 foot(tree.position.x, tree.position.y, tree.position.z);
    const float height = pictures.height * tree.scale.axes.z,
                reach = pictures.halfWidth * tree.scale.axes.x + glm::length(lean);
    const osg::Vec3 away = _eye - foot;
    if (_parallelDirection.length2() == 0.0f && math::hypot(away.x(), away.y()) < reach &&
        away.z() < 1.2f * height)
        return {};
    osg::Vec3 toEye = towardEye(foot + osg::Vec3(0.0f, 0.0f, 0.5f * height));
    toEye.z() = std::max(toEye.z(), 0.0f); // there are no impostors as seen from below
    toEye.normalize();
    const float level = math::hypot(toEye.x(), toEye.y());
    const osg::Vec2 ahead = level > 1.0e-4f ? osg::Vec2(toEye.x(), toEye.y()) / level : osg::Vec2(1.0f, 0.0f);
    const float across = tree.scale.axes.x * toEye.z(), upward = tree.scale.axes.z * level;
    const auto rows = static_cast<float>(pictures.elevations - 1);
    const int row = static_cast<int>(std::lround(math::atan2(across, upward) / osg::PI_2f * rows));
    const glm::vec2 extent = pictures.extents[static_cast<std::size_t>(row)] * math::hypot(across, upward);

    const osg::Vec3 up(-ahead.x() * toEye.z(), -ahead.y() * toEye.z(), level),
        side(-ahead.y() * tree.scale.axes.x * pictures.halfWidth,
             ahead.x() * tree.scale.axes.x * pictures.halfWidth, 0.0f);
    const osg::Vec3 plane = foot + toEye * (0.5f * height * toEye.z());
    const osg::Vec3 low = plane + up * extent.x, high = plane + up * extent.y + osg::Vec3(lean.x, lean.y, 0);
    OcclusionBuffer::Billboard billboard;
    osg::Vec2 left, right;
    if (!projectPoint(_toClip, low, billboard.low) || !projectPoint(_toClip, high, billboard.high) ||
        !projectPoint(_toClip, (low + high) * 0.5f - side, left) ||
        !projectPoint(_toClip, (low + high) * 0.5f + side, right))
        return {};
    const osg::Vec2 width = (right - left) * 0.5f;
    billboard.halfWidth = std::abs(width.x());
    if (std::abs(width.y()) > 0.3f * billboard.halfWidth || !(billboard.high.y() > billboard.low.y()) ||
        !(billboard.halfWidth > 0.0f))
        return {};
    billboard.coverage = &impostor.coverage().grid(row);
    return billboard;
}

} // namespace osgTreeWind
