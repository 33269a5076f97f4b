// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// What a written date and time means, in seconds since 1970-01-01T00:00Z. Both readings are set and equal if
/// the text tells the order of day and month; "26/10/2017" has no second reading.
struct DateReadings {
    std::optional<double> dayFirst, monthFirst;
    bool hasZone = false; ///< Otherwise the time is taken as UTC.

    bool isRead() const { return dayFirst || monthFirst; }
};

/// Reads a date, or a date and time, as people and services write them: "2017-10-26T15:00:00.5+01:00",
/// "26.10.2017 15:00", "10/26/17 3:00 PM", "26-Oct-2017", "20171026T1500Z", "201710261500", 24:00 for
/// midnight. Texts with other zones than UTC, GMT, Z and offsets are not read.
DateReadings readDate(std::string_view text);

/// Reads a whole text by a format of Hinnant's date library, such as "%d.%m.%Y %H.%M".
DateReadings readDate(std::string_view text, const std::string& format);

/// The time of a text that has one reading in readDate(), in seconds since 1970-01-01T00:00Z.
std::optional<double> parseDate(std::string_view text);

/// Formats seconds since 1970-01-01T00:00Z, truncated to whole seconds, as "2017-06-03T18:00:00Z".
std::string isoTimeText(double seconds);

} // namespace osgTreeWind
