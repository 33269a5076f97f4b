// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace osgTreeWind {

/// What a noise of the laws is asked for: a time in periods, split so that hours of simulation keep their
/// precision in floats, and the kind of noise.
struct NoiseTime {
    std::uint32_t cell = 0; ///< Whole periods, modulo 2^32.
    float fraction = 0.0f;  ///< In [0, 1).
    float gain = 0.0f;      ///< Of each octave over the one before; 0: a single one, Perlin noise.

    /// @param time seconds. @param frequency Hz, >= 0. What is not finite counts as 0.
    /// @param exponent beta of 1/f^beta noise, taken within [0, 3]; periods are then those of its slowest
    /// octave, an eighth of the frequency (shaders/law/noise.glsl). None, or not finite: Perlin noise.
    static NoiseTime at(double time, float frequency, std::optional<float> exponent = {});
};

} // namespace osgTreeWind
