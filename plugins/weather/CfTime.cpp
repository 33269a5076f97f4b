// SPDX-License-Identifier: MIT
#include <plugins/weather/CfTime.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <regex>
#include <string_view>
#include <tuple>
#include <utility>

namespace osgTreeWind {

namespace {

struct CfDate {
    int year = 1970, month = 1, day = 1;
};

/// A calendar of the CF conventions. Days are counted from 1970-01-01 Gregorian, or from 1 January 0000 in
/// calendars with years of a fixed length.
class CfCalendar {
public:
    /// The calendar with a CF name such as "noleap"; no name means the standard one. Empty if unknown.
    static std::optional<CfCalendar> named(const std::string& name);

    /// Whether its dates are those of the Gregorian (before 1582, Julian) calendar.
    bool isCivil() const { return _kind == Kind::Standard || _kind == Kind::Proleptic; }
    bool has(const CfDate& date) const;
    std::int64_t dayOf(const CfDate& date) const;
    CfDate dateOf(std::int64_t day) const;

private:
    enum class Kind { Standard, Proleptic, NoLeap, AllLeap, Days360 };

    explicit CfCalendar(Kind kind) : _kind(kind) {}
    int daysIn(int year, int month) const;
    bool isJulian(const CfDate& date) const;

    Kind _kind;
};

constexpr std::int64_t daysToEpoch = 719468;        // from 1 March 0000, so that a leap day ends a year
constexpr std::int64_t firstGregorianDay = -141427; // 15 October 1582
constexpr std::int64_t firstJulianDay = -719470;    // 1 March 0000 of the Julian calendar

std::int64_t floorDivide(std::int64_t number, std::int64_t divisor) {
    return number / divisor - (number % divisor < 0 ? 1 : 0);
}

std::int64_t dayOfMarchYear(const CfDate& date) {
    return (153 * ((date.month + 9) % 12) + 2) / 5 + date.day - 1;
}

/// @param year begins in March. @param day of that year, from 0.
CfDate dateInMarchYear(std::int64_t year, std::int64_t day) {
    const auto month = static_cast<int>((5 * day + 2) / 153);
    return {static_cast<int>(year) + (month < 10 ? 0 : 1), month < 10 ? month + 3 : month - 9,
            static_cast<int>(day) - (153 * month + 2) / 5 + 1};
}

std::optional<CfCalendar> CfCalendar::named(const std::string& name) {
    static const std::pair<const char*, Kind> names[] = {
        {"", Kind::Standard},          {"standard", Kind::Standard},
        {"gregorian", Kind::Standard}, {"proleptic_gregorian", Kind::Proleptic},
        {"noleap", Kind::NoLeap},      {"365_day", Kind::NoLeap},
        {"all_leap", Kind::AllLeap},   {"366_day", Kind::AllLeap},
        {"360_day", Kind::Days360}};
    for (const auto& [known, kind] : names)
        if (lower(name) == known)
            return CfCalendar(kind);
    return std::nullopt;
}

bool CfCalendar::isJulian(const CfDate& date) const {
    return _kind == Kind::Standard && std::tuple(date.year, date.month, date.day) < std::tuple(1582, 10, 15);
}

int CfCalendar::daysIn(int year, int month) const {
    constexpr int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (_kind == Kind::Days360)
        return 30;
    const bool gregorian = year % 100 != 0 || year % 400 == 0 || isJulian({year, month, 1});
    const bool leap = _kind == Kind::AllLeap || (_kind != Kind::NoLeap && year % 4 == 0 && gregorian);
    return month == 2 && leap ? 29 : days[month - 1];
}

bool CfCalendar::has(const CfDate& date) const {
    return date.year >= 0 && date.year <= 9999 && date.month >= 1 && date.month <= 12 && date.day >= 1 &&
           date.day <= daysIn(date.year, date.month);
}

std::int64_t CfCalendar::dayOf(const CfDate& date) const {
    if (!isCivil()) {
        std::int64_t day = date.day - 1;
        for (int month = 1; month < date.month; ++month)
            day += daysIn(date.year, month);
        const int perYear = _kind == Kind::Days360 ? 360 : _kind == Kind::NoLeap ? 365 : 366;
        return std::int64_t(perYear) * date.year + day;
    }
    const std::int64_t year = date.month > 2 ? date.year : date.year - 1,
                       days = 365 * year + floorDivide(year, 4) + dayOfMarchYear(date);
    if (isJulian(date))
        return days + firstJulianDay;
    return days - floorDivide(year, 100) + floorDivide(year, 400) - daysToEpoch;
}

CfDate CfCalendar::dateOf(std::int64_t day) const {
    if (!isCivil()) {
        const int perYear = _kind == Kind::Days360 ? 360 : _kind == Kind::NoLeap ? 365 : 366;
        CfDate date{static_cast<int>(floorDivide(day, perYear)), 1, 1};
        day -= std::int64_t(perYear) * date.year;
        for (; day >= daysIn(date.year, date.month); ++date.month)
            day -= daysIn(date.year, date.month);
        date.day = static_cast<int>(day) + 1;
        return date;
    }
    if (_kind == Kind::Standard && day < firstGregorianDay) {
        const std::int64_t days = day - firstJulianDay, cycle = floorDivide(days, 1461),
                           rest = days - 1461 * cycle, year = rest == 1460 ? 3 : rest / 365;
        return dateInMarchYear(4 * cycle + year, rest - 365 * year);
    }
    const std::int64_t days = day + daysToEpoch, era = floorDivide(days, 146097), rest = days - 146097 * era,
                       year = (rest - rest / 1460 + rest / 36524 - rest / 146096) / 365;
    return dateInMarchYear(400 * era + year, rest - (365 * year + year / 4 - year / 100));
}

/// A date and time in any calendar.
struct Moment {
    CfDate date;
    double seconds = 0.0; ///< Since midnight, UTC.
};

/// Parses "1900-01-01 00:00:00.0 +1:00" and shorter forms.
std::optional<Moment> parseMoment(const std::string& text) {
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

/// Text of a moment plus some seconds: ISO 8601, or in other calendars date, time and calendar name.
std::string textOf(const Moment& moment, double seconds, const CfCalendar& calendar,
                   const std::string& name) {
    const double all = std::round(moment.seconds + seconds), days = std::floor(all / 86400.0);
    if (!(std::abs(days) < 4e6))
        return {};
    const CfDate date = calendar.dateOf(calendar.dayOf(moment.date) + static_cast<std::int64_t>(days));
    const auto rest = static_cast<int>(all - 86400.0 * days);
    const bool usual = calendar.isCivil() && date.year >= 1;
    char text[64];
    std::snprintf(text, sizeof text,
                  usual ? "%04d-%02d-%02dT%02d:%02d:%02dZ" : "%04d-%02d-%02d %02d:%02d:%02d", date.year,
                  date.month, date.day, rest / 3600, rest / 60 % 60, rest % 60);
    return usual ? text : text + std::string(", calendar ") + name;
}

} // namespace

Result<CfTimes> decodeCfTimes(const std::vector<double>& numbers, const std::string& unit,
                              const std::string& calendarName) {
    constexpr std::string_view since = " since ";
    const std::size_t end = lower(unit).find(since);
    const auto scale = knownUnit(Dimension::Time, unit.substr(0, end));
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
    const auto moment = parseMoment(unit.substr(end + since.size()));
    if (!moment || !calendar->has(moment->date))
        return fileProblem({}, expectedFound("times since a date and time, as hours since 1900-01-01 "
                                             "00:00:00",
                                             unit));
    times.start = textOf(*moment, numbers.front() * *scale, *calendar, calendarName);
    return times;
}

} // namespace osgTreeWind
