// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// A time in periods of a noise, split so that hours of simulation keep their precision in floats.
struct NoiseTime {
    std::uint32_t cell = 0; ///< Whole periods, modulo 2^32.
    float fraction = 0.0f;  ///< In [0, 1).

    /// @param time seconds. @param frequency Hz, >= 0. What is not finite counts as 0.
    static NoiseTime at(double time, float frequency);
};

} // namespace osgTreeWind
