// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Horizontal extent of the points of a grid in the coordinates of its file. Unbounded along an axis of one
/// point or a cyclic axis (longitudes of the whole globe).
struct WindExtent {
    /// `low` is -unbounded and `high` is unbounded along an unbounded axis.
    static constexpr double unbounded = 1e300;

    glm::dvec2 low{-unbounded}; ///< The south-western point.
    glm::dvec2 high{unbounded}; ///< The north-eastern point.

    /// Whether an axis is unbounded. @param axis 0: x, 1: y.
    bool isUnbounded(int axis) const { return high[axis] - low[axis] >= unbounded; }
    /// Whether a place is inside the extent.
    bool contains(const glm::dvec2& place) const {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
};

} // namespace osgTreeWind
