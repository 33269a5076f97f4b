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
    std::vector<std::string> time; ///< Time column, or columns whose cells are joined: {"date", "time"}.
    /// "s", "min", "h", "ms", "days" (day 0 is 1899-12-30), or "iso8601" for dates and times in the usual
    /// forms; empty: found from the first time.
    std::string timeUnit;
    std::string timeOrder;  ///< "dmy" or "mdy" for dates such as 01/02/2020; empty: a day above 12 tells it.
    std::string timeFormat; ///< Form of dates and times, "%d.%m.%Y %H.%M"; empty: the usual forms.
    std::string u;          ///< Velocity toward east.
    std::string v;          ///< Velocity toward north.
    std::string w;          ///< Velocity upward; optional.
    std::string speed;      ///< Horizontal speed, not negative.
    std::string direction;  ///< Clockwise from north, at most 360 degrees either way, or a compass point.
    std::string directionUnit; ///< "deg", "10 deg" or "rad"; empty: as the column's name says, or else "deg".
    DirectionSense sense = DirectionSense::From; ///< Meaning of `direction`.
    /// Unit of all velocities: "m/s", "km/h", "kn", "mph", "ft/s" or another that UDUNITS knows; empty: as
    /// the names of the columns say, "wind (km/h)", or else m/s.
    std::string speedUnit;
    std::optional<char> delimiter; ///< Separator of columns; ' ': blanks; empty: found.
    std::optional<bool>
        decimalComma; ///< Whether numbers use a decimal comma; empty: if it is not the separator.
    std::optional<int> headerLine; ///< 1-based line of the header; 0: none; empty: found.
    std::string comment;           ///< Beginning of lines to skip; empty: found.
    std::vector<double> missing;   ///< More codes for missing values, besides -99, 999 and similar ones.

    /// Whether any column is named; otherwise readers use default names.
    bool named() const { return !time.empty() || !(u + v + w + speed + direction).empty(); }
};

} // namespace osgTreeWind
