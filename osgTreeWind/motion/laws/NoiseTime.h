// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace osgTreeWind {

/// Time argument of the laws' noise: in periods, split so that hours of simulation keep full precision in
/// floats, with the kind of noise.
struct NoiseTime {
    std::uint32_t cell = 0; ///< Whole periods, modulo 2^32.
    float fraction = 0.0f;  ///< In [0, 1).
    float gain = 0.0f;      ///< Amplitude of each octave over the previous one; 0: one octave, Perlin noise.

    /// @param time seconds. @param frequency Hz, >= 0. Values that are not finite count as 0.
    /// @param exponent beta of 1/f^beta noise, clamped to [0, 3]; a period is then that of the slowest
    /// octave, an eighth of the frequency (shaders/law/noise.glsl). Empty or not finite: Perlin noise.
    static NoiseTime at(double time, float frequency, std::optional<float> exponent = {});
};

} // namespace osgTreeWind
