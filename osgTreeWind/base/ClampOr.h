// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

/// `value` brought into [low, high]; NaN becomes `fallback`.
inline float clampOr(float value, float low, float high, float fallback) {
    if (std::isnan(value))
        return fallback;
    return value < low ? low : value > high ? high : value;
}

} // namespace osgTreeWind
