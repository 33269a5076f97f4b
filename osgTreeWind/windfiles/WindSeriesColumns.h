// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osgTreeWind/wind/WindDirection.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Names and units of the columns of a wind record in a CSV table. Set either u and v (and w) or speed and
/// direction; leave the other names empty.
struct OSGTREEWIND_EXPORT WindSeriesColumns {
    std::string time;                            ///< Time column.
    std::string timeUnit = "s";                  ///< "s", "min", "h", or "iso8601" for dates and times.
    std::string u;                               ///< Velocity toward east.
    std::string v;                               ///< Velocity toward north.
    std::string w;                               ///< Velocity upward; optional.
    std::string speed;                           ///< Horizontal speed, not negative.
    std::string direction;                       ///< Degrees clockwise from north, [-360, 360].
    DirectionSense sense = DirectionSense::From; ///< Meaning of `direction`.
    std::string speedUnit = "m/s"; ///< Unit of all velocities: "m/s", "km/h", "kn", "mph" or "ft/s".
    std::optional<char> delimiter; ///< Separator of columns; empty: guessed from the header.
    std::optional<bool>
        decimalComma;            ///< Whether numbers use a decimal comma; empty: if it is not the separator.
    std::vector<double> missing; ///< More codes for missing values, besides -99, 999 and similar ones.

    /// Whether any column is named; otherwise readers use default names.
    bool named() const { return !(time + u + v + w + speed + direction).empty(); }
};

} // namespace osgTreeWind
