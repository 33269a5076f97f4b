// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

namespace osgTreeWind {

/// The velocity, or 0 if any component is NaN or infinite.
inline glm::vec3 calmUnlessFinite(const glm::vec3& velocity) {
    const bool finite = std::isfinite(velocity.x) && std::isfinite(velocity.y) && std::isfinite(velocity.z);
    return finite ? velocity : glm::vec3(0.0f);
}

/// Converts a velocity to floats, clamped to their range. Not for NaN.
inline glm::vec3 clampedVelocity(const glm::dvec3& velocity) {
    constexpr double limit = std::numeric_limits<float>::max();
    return glm::vec3(glm::clamp(velocity, -limit, limit));
}

/// A time clamped to [-limit, limit] seconds; 0 if it is not finite.
inline double clampedTime(double time, double limit) {
    return std::isfinite(time) ? glm::clamp(time, -limit, limit) : 0.0;
}

} // namespace osgTreeWind
