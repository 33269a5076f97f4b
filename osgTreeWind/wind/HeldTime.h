// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>

#include <cmath>

namespace osgTreeWind {

/// A time that air may be carried for: within `most` seconds; 0 where it is not finite.
inline double heldTime(double time, double most) {
    return std::isfinite(time) ? glm::clamp(time, -most, most) : 0.0;
}

} // namespace osgTreeWind
