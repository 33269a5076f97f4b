// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

namespace osgTreeWind {

/// The velocity itself, or calm when any component is NaN or infinite.
inline glm::vec3 calmUnlessFinite(const glm::vec3& velocity) {
    const bool finite = std::isfinite(velocity.x) && std::isfinite(velocity.y) && std::isfinite(velocity.z);
    return finite ? velocity : glm::vec3(0.0f);
}

/// A velocity computed in double precision, held within what a float can say. Not for NaN.
inline glm::vec3 clampedVelocity(const glm::dvec3& velocity) {
    constexpr double limit = std::numeric_limits<float>::max();
    return glm::vec3(glm::clamp(velocity, -limit, limit));
}

/// A time that air may be carried for: within `most` seconds; 0 where it is not finite.
inline double heldTime(double time, double most) {
    return std::isfinite(time) ? glm::clamp(time, -most, most) : 0.0;
}

} // namespace osgTreeWind
