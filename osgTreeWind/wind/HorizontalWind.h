// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <cmath>

namespace osgTreeWind {

/// The horizontal part of a wind. NaN and more than 10 km/s count as calm; a calm points east.
struct HorizontalWind {
    static constexpr float maxSpeed = 1e4f; ///< m/s

    float speed = 0.0f;
    glm::vec3 along{1.0f, 0.0f, 0.0f};

    HorizontalWind() = default;
    explicit HorizontalWind(const glm::vec3& wind) : speed(std::sqrt(wind.x * wind.x + wind.y * wind.y)) {
        if (!(speed <= maxSpeed))
            speed = 0.0f;
        if (speed > 1e-6f)
            along = glm::vec3(wind.x / speed, wind.y / speed, 0.0f);
    }
};

/// Horizontal mean of a wind at (0, 0) over its first hour, m/s. @param height metres above the ground.
glm::vec3 hourlyMean(const WindField& wind, float height);

} // namespace osgTreeWind
