// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osgTreeWind/wind/WindDirection.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Which columns of a CSV table hold a wind record, and their units.
/// Either u and v (and w), or speed and direction; the names of the others stay empty.
struct OSGTREEWIND_EXPORT WindSeriesColumns {
    std::string time;           ///< Its column.
    std::string timeUnit = "s"; ///< "s", "min", "h", or "iso8601" for dates and times as text.
    std::string u;              ///< Velocity toward east.
    std::string v;              ///< Velocity toward north.
    std::string w;              ///< Velocity upward; optional.
    std::string speed;          ///< Horizontal speed, not negative.
    std::string direction;      ///< Degrees clockwise from north, -360 to 360.
    DirectionSense sense = DirectionSense::From; ///< Of the direction.
    std::string speedUnit = "m/s";               ///< Of all velocities: "m/s", "km/h", "kn", "mph" or "ft/s".
    std::optional<char> delimiter;               ///< Between columns; else the header tells.
    std::optional<bool> decimalComma; ///< Whether numbers have one; else where commas part no cells.
    std::vector<double> missing;      ///< Numbers that stand for no value, beside -99, 999 and the like.

    /// Whether any column is named; otherwise readers take the usual names.
    bool named() const { return !(time + u + v + w + speed + direction).empty(); }
};

} // namespace osgTreeWind
