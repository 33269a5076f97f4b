// SPDX-License-Identifier: MIT
#include <plugins/weather/CfTime.h>

#include <plugins/weather/CfCalendar.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <regex>
#include <string_view>

namespace osgTreeWind {

namespace {

/// A moment of some calendar.
struct Moment {
    CfDate date;
    double seconds = 0.0; ///< From its midnight in UTC.
};

/// Seconds in a unit of time such as "hours" or "Hour"; nothing for another.
std::optional<double> secondsOf(const std::string& unit) {
    static const std::pair<const char*, double> units[] = {
        {"s", 1.0},     {"sec", 1.0},     {"second", 1.0}, {"min", 60.0},    {"minute", 60.0},  {"h", 3600.0},
        {"hr", 3600.0}, {"hour", 3600.0}, {"d", 86400.0},  {"day", 86400.0}, {"week", 604800.0}};
    const std::string name = lower(unit);
    for (const auto& [known, seconds] : units)
        if (name == known || name == std::string(known) + "s")
            return seconds;
    return std::nullopt;
}

/// "1900-01-01 00:00:00.0 +1:00", and shorter.
std::optional<Moment> momentOf(const std::string& text) {
    static const std::regex form(R"(\s*(\d{1,4})-(\d{1,2})-(\d{1,2}))"
                                 R"((?:[T _]+(\d{1,2})(?::(\d{1,2})(?::(\d{1,2}(?:\.\d*)?))?)?)?)"
                                 R"(\s*(?:Z|UTC|GMT|([+-])(\d{1,2})(?::?(\d{2}))?)?\s*)",
                                 std::regex::icase);
    std::smatch parts;
    if (text.size() > 64 || !std::regex_match(text, parts, form))
        return std::nullopt;
    const auto number = [&](std::size_t i) { return parseNumber(parts[i].str()).value_or(0.0); };
    const auto whole = [&](std::size_t i) { return static_cast<int>(number(i)); };
    const double zone = (parts[7].str() == "-" ? -60.0 : 60.0) * (60.0 * number(8) + number(9));
    if (number(4) > 24.0 || number(5) > 59.0 || number(6) >= 61.0)
        return std::nullopt;
    return Moment{{whole(1), whole(2), whole(3)}, 3600.0 * number(4) + 60.0 * number(5) + number(6) - zone};
}

/// The moment so many seconds later: in ISO 8601 where the calendar is a usual one.
std::string textOf(const Moment& moment, double seconds, const CfCalendar& calendar,
                   const std::string& name) {
    const double all = std::round(moment.seconds + seconds), days = std::floor(all / 86400.0);
    if (!(std::abs(days) < 4e6))
        return {};
    const CfDate date = calendar.dateOf(calendar.dayOf(moment.date) + static_cast<std::int64_t>(days));
    const auto rest = static_cast<int>(all - 86400.0 * days);
    const bool usual = calendar.isUsual() && date.year >= 1;
    char text[64];
    std::snprintf(text, sizeof text,
                  usual ? "%04d-%02d-%02dT%02d:%02d:%02dZ" : "%04d-%02d-%02d %02d:%02d:%02d", date.year,
                  date.month, date.day, rest / 3600, rest / 60 % 60, rest % 60);
    return usual ? text : text + std::string(", calendar ") + name;
}

} // namespace

Result<CfTimes> cfTimes(const std::vector<double>& numbers, const std::string& unit,
                        const std::string& calendarName) {
    constexpr std::string_view since = " since ";
    const std::size_t end = lower(unit).find(since);
    const auto scale = secondsOf(unit.substr(0, end));
    if (!scale || numbers.empty())
        return fileProblem({}, expectedFound("times in seconds, minutes, hours, days or weeks", unit));
    CfTimes times;
    for (const double number : numbers)
        times.seconds.push_back((number - numbers.front()) * *scale);
    if (end == std::string::npos)
        return times;
    const auto calendar = CfCalendar::named(calendarName);
    if (!calendar)
        return fileProblem({}, expectedFound("a calendar (standard, gregorian, proleptic_gregorian, noleap, "
                                             "365_day, all_leap, 366_day or 360_day)",
                                             calendarName));
    const auto moment = momentOf(unit.substr(end + since.size()));
    if (!moment || !calendar->has(moment->date))
        return fileProblem({}, expectedFound("times since a date and time, as hours since 1900-01-01 "
                                             "00:00:00",
                                             unit));
    times.start = textOf(*moment, numbers.front() * *scale, *calendar, calendarName);
    return times;
}

} // namespace osgTreeWind
