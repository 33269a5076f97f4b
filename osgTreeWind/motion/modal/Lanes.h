// SPDX-License-Identifier: MIT
#pragma once

// SIMD lanes: a vector of floats that behaves as one number, and the law files compiled for it. For sources
// that are compiled once per instruction set; all of it has internal linkage.

namespace osgTreeWind {
namespace {

#ifdef __AVX__
inline constexpr int laneCount = 8;
#else
inline constexpr int laneCount = 4;
#endif
using real [[gnu::vector_size(4 * laneCount)]] = float;
using wholeLanes [[gnu::vector_size(4 * laneCount)]] = int;

inline real every(float x) {
    return x - real{};
}
inline real min(real a, real b) {
    return a < b ? a : b;
}
inline real max(real a, real b) {
    return a > b ? a : b;
}
inline real abs(real x) {
    return reinterpret_cast<real>(reinterpret_cast<wholeLanes>(x) & 0x7fffffff);
}
inline real sqrt(real x) {
    for (int i = 0; i < laneCount; ++i)
        x[i] = __builtin_sqrtf(x[i]);
    return x;
}
/// For values in the range of int.
inline real floor(real x) {
    const real whole = __builtin_convertvector(__builtin_convertvector(x, wholeLanes), real);
    return whole > x ? whole - 1.0f : whole;
}
inline real halvings(real n) {
    return reinterpret_cast<real>((127 - __builtin_convertvector(n, wholeLanes)) << 23);
}

/// The law files that are written for `real`.
struct LaneLaws {
#include <shaders/law/limits.glsl>

#include <shaders/law/elementary.glsl>

#include <shaders/law/oscillator.glsl>

#include <shaders/law/modal.glsl>
};

/// Traits for ModalAir.
struct Lanes {
    using Number = real;
    using Laws = LaneLaws;
    static real every(float x) { return osgTreeWind::every(x); }
    static real root(real x) { return sqrt(x); }
};

} // namespace
} // namespace osgTreeWind
