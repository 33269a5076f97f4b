// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

/// Times as GRIB has them, UTC.
namespace osgTreeWind::GribTime {

/// A date and time of day.
struct Date {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
};

/// Seconds since 1970; nothing for a day or hour that does not exist.
std::optional<double> secondsOf(const Date& date);
/// Seconds of the unit that both editions number so; nothing for months, years and what is unknown.
std::optional<double> secondsOfUnit(int edition, int unit);
/// Seconds since 1970 as ISO 8601: "2017-06-03T18:00:00Z".
std::string text(double seconds);

} // namespace osgTreeWind::GribTime
