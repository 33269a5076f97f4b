// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <cstdint>

namespace osgTreeWind {

/// A random number in [0, 1) for a point of a grid.
inline float randomAt(std::uint32_t x, std::uint32_t y, std::uint32_t stream) {
    std::uint32_t n = x * 0x9e3779b9u ^ y * 0x85ebca6bu ^ stream * 0xc2b2ae35u;
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    return static_cast<float>((n ^ (n >> 16)) >> 8) * (1.0f / 16777216.0f);
}

/// The coordinate in [0, period) of which `place` is a repetition.
inline std::uint32_t wrapped(int place, int period) {
    if ((period & (period - 1)) == 0) // a power of two
        return static_cast<std::uint32_t>(place & (period - 1));
    const int rest = place % period;
    return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
}

/// The largest integer not above a number, without a call of std::floor().
inline int wholeBelow(float place) {
    const int whole = static_cast<int>(place);
    return static_cast<float>(whole) > place ? whole - 1 : whole;
}

/// Value noise in [0, 1]: a smooth interpolation of randomAt() between grid points.
inline float valueNoise(const glm::vec2& place, const glm::ivec2& period, std::uint32_t stream) {
    const glm::ivec2 cell(wholeBelow(place.x), wholeBelow(place.y));
    const glm::vec2 part = glm::smoothstep(0.0f, 1.0f, place - glm::vec2(cell));
    const std::uint32_t left = wrapped(cell.x, period.x), low = wrapped(cell.y, period.y);
    const auto next = [](std::uint32_t place, int end) {
        return place + 1 < static_cast<std::uint32_t>(end) ? place + 1 : 0;
    };
    const std::uint32_t right = next(left, period.x), high = next(low, period.y);
    return glm::mix(glm::mix(randomAt(left, low, stream), randomAt(right, low, stream), part.x),
                    glm::mix(randomAt(left, high, stream), randomAt(right, high, stream), part.x), part.y);
}

/// Fractal noise in [0, 1]: octaves of value noise with doubled frequency and halved amplitude.
inline float fractalNoise(const glm::vec2& place, int octaves, const glm::ivec2& period,
                          std::uint32_t stream) {
    float sum = 0.0f, weights = 0.0f, weight = 1.0f;
    for (int i = 0; i < octaves; ++i, weight *= 0.5f) {
        sum += weight * valueNoise(static_cast<float>(1 << i) * place, period * (1 << i),
                                   stream + static_cast<std::uint32_t>(i));
        weights += weight;
    }
    return sum / weights;
}

} // namespace osgTreeWind
