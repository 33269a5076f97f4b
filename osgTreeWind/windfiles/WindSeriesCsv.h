// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindSeries.h>

#include <istream>
#include <string>

namespace osgTreeWind {

/// Which columns of a CSV table hold a wind record, and their units.
/// Either u and v (and w), or speed and direction; the names of the others stay empty.
struct WindSeriesColumns {
    std::string time;
    std::string timeUnit = "s"; ///< "s", "min", "h", or "iso8601" for dates and times as text.
    std::string u;              ///< Velocity toward east.
    std::string v;              ///< Velocity toward north.
    std::string w;              ///< Velocity upward; optional.
    std::string speed;          ///< Horizontal speed, not negative.
    std::string direction;      ///< Degrees clockwise from north, -360 to 360.
    DirectionSense sense = DirectionSense::From;
    std::string speedUnit = "m/s"; ///< Of all velocities: "m/s", "km/h", "kn", "mph" or "ft/s".
    char delimiter = ',';
};

/// Reads a wind record; times become seconds since its first row. Every problem is reported: a column map
/// that names both forms or neither, a missing column, an unknown unit, and, with its line, a cell that is
/// no number, a time that does not increase, or a value no wind has (negative speed, more than 200 m/s).
/// @param file name for diagnostics only.
Result<WindSeries> readWindSeriesCsv(std::istream& input, const std::string& file,
                                     const WindSeriesColumns& columns);

/// The same for a table that has been read already.
Result<WindSeries> windSeriesOf(const CsvTable& table, const WindSeriesColumns& columns);

} // namespace osgTreeWind
