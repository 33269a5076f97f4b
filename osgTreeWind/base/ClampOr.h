// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

/// `value` clamped to [low, high], or `fallback` if it is NaN.
template <typename T>
T clampOr(T value, T low, T high, T fallback) {
    if (std::isnan(value))
        return fallback;
    return value < low ? low : value > high ? high : value;
}

} // namespace osgTreeWind
