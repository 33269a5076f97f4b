// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {

/// The rotation by `angle` radians about a unit axis.
template <typename T>
glm::qua<T> rotationAbout(const glm::vec<3, T>& axis, T angle) {
    return {math::cos(T(0.5) * angle), math::sin(T(0.5) * angle) * axis};
}

} // namespace osgTreeWind
