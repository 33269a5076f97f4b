// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>

#include <osg/Quat>
#include <osg/Vec3>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {

inline osg::Vec3 toOsg(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
inline osg::Quat toOsg(const glm::quat& q) {
    return {q.x, q.y, q.z, q.w};
}
/// The rotation by `angle` radians about the vertical.
inline osg::Quat aboutVertical(double angle) {
    return {0.0, 0.0, math::sin(0.5 * angle), math::cos(0.5 * angle)};
}

} // namespace osgTreeWind
