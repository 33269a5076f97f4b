// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace osgTreeWind {

constexpr glm::vec3 up{0.0f, 0.0f, 1.0f};

/// `v` normalized, or `fallback` if `v` is shorter than 1e-4.
inline glm::vec3 directionOr(const glm::vec3& v, const glm::vec3& fallback) {
    return glm::dot(v, v) > 1e-8f ? glm::normalize(v) : fallback;
}

/// A unit vector perpendicular to the unit vector `axis`, close to +x, or to +y if `axis` is close to x.
template <typename T>
glm::vec<3, T> perpendicular(const glm::vec<3, T>& axis) {
    const glm::vec<3, T> hint = std::abs(axis.x) < T(0.9) ? glm::vec<3, T>(1, 0, 0) : glm::vec<3, T>(0, 1, 0);
    return glm::normalize(hint - axis * glm::dot(hint, axis));
}

} // namespace osgTreeWind
