// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Where a value falls between two neighbouring samples: lower + fraction * (upper - lower).
struct Interpolation {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double fraction = 0.0; ///< In [0, 1].

    /// Linear between two values; exactly either of them at the ends.
    template <typename T>
    T mix(const T& low, const T& high) const {
        return low * (1.0 - fraction) + high * fraction;
    }
};

/// The samples around a coordinate counted in samples, out of `count` (at least 1); held at both ends.
/// NaN gives the first.
Interpolation interpolationAtIndex(double index, std::size_t count);

/// The samples around a time; before the first and after the last they are held. NaN gives the first.
/// @param times at least one, checked by checkTimes().
Interpolation interpolationAtTime(double time, const std::vector<double>& times);

/// A problem with key "times" unless they are within 1e15 s and strictly increasing; empty when they are.
Diagnostics checkTimes(const std::vector<double>& times);

} // namespace osgTreeWind
