// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstring>

// SIMD lanes: a vector of floats that behaves as one number, and the law files compiled for it. For sources
// that are compiled once per instruction set; all of it has internal linkage.

namespace osgTreeWind {
namespace {

#if defined(__GNUC__) && !defined(OSGTREEWIND_PLAIN_LANES)

/// Calls nothing from a function: everything becomes a part of it.
#define OSGTREEWIND_FLATTEN __attribute__((flatten))

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
inline real abs(real x) {
    return reinterpret_cast<real>(reinterpret_cast<wholeLanes>(x) & 0x7fffffff);
}
inline real sqrt(real x) {
    for (int i = 0; i < laneCount; ++i)
        x[i] = __builtin_sqrtf(x[i]);
    return x;
}
/// Without the fraction; for values in the range of int.
inline real truncated(real x) {
    return __builtin_convertvector(__builtin_convertvector(x, wholeLanes), real);
}
inline real halvings(real n) {
    return reinterpret_cast<real>((127 - __builtin_convertvector(n, wholeLanes)) << 23);
}

#else // a compiler without vectors, such as that of Visual Studio: one tree at a time

#define OSGTREEWIND_FLATTEN

inline constexpr int laneCount = 1;
using real = float;

inline real every(float x) {
    return x;
}
inline real abs(real x) {
    return std::fabs(x);
}
inline real sqrt(real x) {
    return std::sqrt(x);
}
inline real truncated(real x) {
    return static_cast<float>(static_cast<int>(x));
}
inline real halvings(real n) {
    const int bits = (127 - static_cast<int>(n)) * (1 << 23);
    real power;
    std::memcpy(&power, &bits, sizeof power);
    return power;
}

#endif

inline real min(real a, real b) {
    return a < b ? a : b;
}
inline real max(real a, real b) {
    return a > b ? a : b;
}
/// For values in the range of int.
inline real floor(real x) {
    const real whole = truncated(x);
    return whole > x ? whole - 1.0f : whole;
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
