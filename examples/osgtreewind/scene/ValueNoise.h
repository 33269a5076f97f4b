// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

/// Noise between random values at whole places (value noise), smooth, in [0, 1].
/// @param period whole places after which it repeats, each way.
inline float valueNoise(float x, float y, std::uint32_t seed, int period = 1 << 24) {
    const float column = std::floor(x), row = std::floor(y);
    const auto random = [&](int i, int j) {
        const auto wrapped = [period](float cell, int step) {
            const int at = (static_cast<int>(cell) + step) % period;
            return static_cast<std::uint32_t>(at < 0 ? at + period : at);
        };
        std::uint32_t n =
            wrapped(column, i) * 0x9e3779b9u ^ wrapped(row, j) * 0x85ebca6bu ^ seed * 0xc2b2ae35u;
        n = (n ^ (n >> 16)) * 0x7feb352du;
        n = (n ^ (n >> 15)) * 0x846ca68bu;
        return static_cast<float>((n ^ (n >> 16)) >> 8) * (1.0f / 16777216.0f);
    };
    const float s = x - column, t = y - row;
    const float u = s * s * (3.0f - 2.0f * s), v = t * t * (3.0f - 2.0f * t);
    const float low = random(0, 0) + u * (random(1, 0) - random(0, 0)),
                high = random(0, 1) + u * (random(1, 1) - random(0, 1));
    return low + v * (high - low);
}

/// Octaves of it, each twice as fine and half as strong, in [0, 1].
inline float fractalNoise(float x, float y, int octaves, std::uint32_t seed, int period = 1 << 20) {
    float sum = 0.0f, weights = 0.0f, weight = 1.0f;
    for (int i = 0; i < octaves; ++i, weight *= 0.5f) {
        const auto scale = static_cast<float>(1 << i);
        sum += weight * valueNoise(scale * x, scale * y, seed + static_cast<std::uint32_t>(i), period << i);
        weights += weight;
    }
    return sum / weights;
}
