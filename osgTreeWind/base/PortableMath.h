// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

/// Float functions that give the same result on all machines, so that a seed always grows the same tree. They
/// compute in double and round once: float versions of the C library differ in the last bit. Radians.
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
