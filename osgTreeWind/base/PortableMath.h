// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

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

} // namespace osgTreeWind
