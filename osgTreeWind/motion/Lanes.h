// SPDX-License-Identifier: MIT
#pragma once

// Eight floats as one number, and the law files compiled for it. For sources that are compiled once for each
// instruction set: all of it is local to them.

namespace osgTreeWind {
namespace {

typedef float real __attribute__((vector_size(32)));
typedef int wholeLanes __attribute__((vector_size(32)));

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
    for (int i = 0; i < 8; ++i)
        x[i] = __builtin_sqrtf(x[i]);
    return x;
}
/// For numbers within the range of an int.
inline real floor(real x) {
    const real whole = __builtin_convertvector(__builtin_convertvector(x, wholeLanes), real);
    return whole > x ? whole - 1.0f : whole;
}
inline real halvings(real n) {
    return reinterpret_cast<real>((127 - __builtin_convertvector(n, wholeLanes)) << 23);
}

/// The law files that say `real`.
struct LaneLaws {
#include <shaders/law/limits.glsl>

#include <shaders/law/elementary.glsl>

#include <shaders/law/oscillator.glsl>

#include <shaders/law/modal.glsl>
};

} // namespace
} // namespace osgTreeWind
