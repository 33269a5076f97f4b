// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Where the points of a grid are, in the coordinates of its file: from the south-western to the
/// north-eastern one. Along an axis of one point, or one that goes all the way round, it holds everywhere.
struct WindExtent {
    static constexpr double everywhere = 1e300;

    glm::dvec2 low{-everywhere}, high{everywhere};

    bool isEverywhere(int axis) const { return high[axis] - low[axis] >= everywhere; }
    bool holds(const glm::dvec2& place) const {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
};

} // namespace osgTreeWind
