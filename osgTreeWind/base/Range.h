// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

namespace osgTreeWind {

/// A valid range of numbers, [min, max] or (min, max].
struct Range {
    double min = -std::numeric_limits<float>::max();
    double max = std::numeric_limits<float>::max();
    bool aboveMin = false; ///< `min` itself is excluded.

    bool contains(double value) const { return value <= max && (aboveMin ? value > min : value >= min); }
    std::string text() const; ///< For messages: "at least 1", "in (0, 1]".
};

constexpr Range within(double min, double max) {
    return {min, max, false};
}
constexpr Range above(double min, double max = Range().max) {
    return {min, max, true};
}
constexpr Range atLeast(double min) {
    return {min, Range().max, false};
}

/// World coordinates in metres, large enough for any map projection of the Earth.
constexpr Range worldCoordinates = within(-1e8, 1e8);

} // namespace osgTreeWind
