// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A position between two neighbouring samples: lower + fraction * (upper - lower).
struct Interpolation {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double fraction = 0.0; ///< In [0, 1].

    /// Linear interpolation; exactly `low` or `high` at the ends.
    template <typename T>
    T mix(const T& low, const T& high) const {
        return low * (1.0 - fraction) + high * fraction;
    }
};

/// The samples around a fractional index, clamped to [0, count - 1]; NaN gives the first. `count` > 0.
Interpolation interpolationAtIndex(double index, std::size_t count);

/// The samples around a time, clamped to the first and last time. NaN gives the first.
/// @param times at least one, accepted by checkTimes().
Interpolation interpolationAtTime(double time, const std::vector<double>& times);

} // namespace osgTreeWind
