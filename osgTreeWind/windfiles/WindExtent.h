// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Where the points of a grid are, in the coordinates of its file. Along an axis of one point, or one that
/// goes all the way round, it holds everywhere.
struct WindExtent {
    /// What `low` and `high` are, negative and positive, along an axis along which it holds everywhere.
    static constexpr double everywhere = 1e300;

    glm::dvec2 low{-everywhere}; ///< The south-western point.
    glm::dvec2 high{everywhere}; ///< The north-eastern point.

    /// Whether it holds everywhere along an axis. @param axis 0: x, 1: y.
    bool isEverywhere(int axis) const { return high[axis] - low[axis] >= everywhere; }
    /// Whether a place lies between the points.
    bool holds(const glm::dvec2& place) const {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
};

} // namespace osgTreeWind
