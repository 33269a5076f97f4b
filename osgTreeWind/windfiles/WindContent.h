// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/WindSeries.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace osgTreeWind {

/// What a file of wind data was understood to say, in the file's own coordinates.
struct WindSummary {
    std::string format;      ///< "TurbSim full field", say.
    std::string unit;        ///< Of the speeds in the file; empty when it does not say.
    std::string direction;   ///< "from, clockwise from grid north" or what the components mean.
    std::string coordinates; ///< Name or PROJ text of the reference system; empty when not said.
    /// The same as PROJ reads it, where points are x east and y north of a map in metres, or longitude and
    /// latitude in degrees; empty when not said.
    std::string crs;
    /// Date and time of time 0, as ISO 8601 in UTC where the file's calendar is the usual one; empty when it
    /// does not say.
    std::string start;
    std::vector<std::string> notes; ///< What else is worth knowing, one sentence each.

    glm::ivec3 points{1};      ///< Points east, north and up; 1, 1, 1 for a record at one point.
    glm::dvec3 low{0.0};       ///< South-western lowest point; all 0 for a record at one point.
    glm::dvec3 high{0.0};      ///< North-eastern highest point.
    bool aboveGround = false;  ///< Heights count from the ground below each place.
    std::vector<double> times; ///< Seconds; empty for a wind that does not change.
    double slowest = 0.0;      ///< m/s, over all points and times.
    double fastest = 0.0;      ///< m/s, likewise.
};

/// What the reader of one format hands over: velocities in the file's unit along the axes of its own map (on
/// degrees: toward east and true north), NaN where it has no data, and the textual part of the summary.
struct WindContent {
    WindSummary summary;                           ///< What it says of itself.
    std::variant<GridWind::Grid, WindSeries> data; ///< On a grid, or over time at one place.
    std::size_t missing = 0;                       ///< Velocities without data that were taken as calm.
    double travelSpeed = 0.0; ///< m/s along x at which the whole grid drifts past; 0 where it stands.
};

} // namespace osgTreeWind
