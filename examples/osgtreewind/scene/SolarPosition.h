// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Position of the sun, degrees: azimuth clockwise from north, [0, 360), and apparent elevation above the
/// horizon, including refraction (half a degree at the horizon).
///
/// Low-precision formulas of the Astronomical Almanac and refraction as in J. J. Michalsky, Solar Energy 40
/// (1988): accurate to 0.01 degrees from 1950 to 2050.
struct SolarPosition {
    /// @param time seconds since 1970-01-01T00:00Z. @param longitudeLatitude degrees east and north.
    SolarPosition(double time, const glm::dvec2& longitudeLatitude);

    double azimuth, elevation;
};

} // namespace osgTreeWind
