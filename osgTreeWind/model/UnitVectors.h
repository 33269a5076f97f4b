// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace osgTreeWind {

/// `v` with unit length, or `fallback` when `v` is too short to have a direction.
inline glm::vec3 directionOr(const glm::vec3& v, const glm::vec3& fallback) {
    return glm::dot(v, v) > 1e-8f ? glm::normalize(v) : fallback;
}

/// A unit vector across the unit vector `axis`: the one nearest to +x, or to +y for an axis close to x.
inline glm::vec3 perpendicular(const glm::vec3& axis) {
    const glm::vec3 hint = std::abs(axis.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(hint - axis * glm::dot(hint, axis));
}

} // namespace osgTreeWind
