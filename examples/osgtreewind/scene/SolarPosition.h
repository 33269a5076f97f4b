// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Where the sun stands in the sky, degrees: azimuth clockwise from north, [0, 360), and elevation above the
/// horizon, as it is seen: air bends it up by half a degree there.
///
/// The Astronomical Almanac's formulas of low precision, as in J. J. Michalsky, Solar Energy 40 (1988): right
/// to 0.01 degrees from 1950 to 2050. Refraction is that of Michalsky, too.
struct SolarPosition {
    /// @param time seconds since 1970-01-01T00:00Z. @param longitudeLatitude degrees, east and north.
    SolarPosition(double time, const glm::dvec2& longitudeLatitude);

    double azimuth, elevation;
};

} // namespace osgTreeWind
