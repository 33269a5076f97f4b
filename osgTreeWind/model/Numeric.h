// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace osgTreeWind {

/// `value` brought into [low, high]; NaN becomes `fallback`.
inline float inRange(float value, float low, float high, float fallback) {
    if (std::isnan(value))
        return fallback;
    return value < low ? low : value > high ? high : value;
}

/// Computed in double and rounded once: the float versions of the C library differ between machines in the
/// last bit, and one seed has to give one tree on all of them. Angles in radians.
inline float sine(float angle) {
    return static_cast<float>(std::sin(static_cast<double>(angle)));
}
inline float cosine(float angle) {
    return static_cast<float>(std::cos(static_cast<double>(angle)));
}
inline float power(float base, float exponent) {
    return static_cast<float>(std::pow(static_cast<double>(base), static_cast<double>(exponent)));
}

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
