// SPDX-License-Identifier: MIT
#include <plugins/weather/CfCalendar.h>

#include <osgTreeWind/base/Text.h>

#include <tuple>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::int64_t daysToEpoch = 719468;        // from 1 March 0000, where counting leap days is easy
constexpr std::int64_t firstGregorianDay = -141427; // 15 October 1582
constexpr std::int64_t firstJulianDay = -719470;    // 1 March 0000 of the Julian calendar

std::int64_t quotient(std::int64_t number, std::int64_t divisor) {
    return number / divisor - (number % divisor < 0 ? 1 : 0);
}

std::int64_t dayOfMarchYear(const CfDate& date) {
    return (153 * ((date.month + 9) % 12) + 2) / 5 + date.day - 1;
}

/// @param year that begins in March. @param day of it.
CfDate dateInMarchYear(std::int64_t year, std::int64_t day) {
    const auto month = static_cast<int>((5 * day + 2) / 153);
    return {static_cast<int>(year) + (month < 10 ? 0 : 1), month < 10 ? month + 3 : month - 9,
            static_cast<int>(day) - (153 * month + 2) / 5 + 1};
}

} // namespace

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
    if (!isUsual()) {
        std::int64_t day = date.day - 1;
        for (int month = 1; month < date.month; ++month)
            day += daysIn(date.year, month);
        const int perYear = _kind == Kind::Days360 ? 360 : _kind == Kind::NoLeap ? 365 : 366;
        return std::int64_t(perYear) * date.year + day;
    }
    const std::int64_t year = date.month > 2 ? date.year : date.year - 1,
                       days = 365 * year + quotient(year, 4) + dayOfMarchYear(date);
    if (isJulian(date))
        return days + firstJulianDay;
    return days - quotient(year, 100) + quotient(year, 400) - daysToEpoch;
}

CfDate CfCalendar::dateOf(std::int64_t day) const {
    if (!isUsual()) {
        const int perYear = _kind == Kind::Days360 ? 360 : _kind == Kind::NoLeap ? 365 : 366;
        CfDate date{static_cast<int>(quotient(day, perYear)), 1, 1};
        day -= std::int64_t(perYear) * date.year;
        for (; day >= daysIn(date.year, date.month); ++date.month)
            day -= daysIn(date.year, date.month);
        date.day = static_cast<int>(day) + 1;
        return date;
    }
    if (_kind == Kind::Standard && day < firstGregorianDay) {
        const std::int64_t days = day - firstJulianDay, cycle = quotient(days, 1461),
                           rest = days - 1461 * cycle, year = rest == 1460 ? 3 : rest / 365;
        return dateInMarchYear(4 * cycle + year, rest - 365 * year);
    }
    const std::int64_t days = day + daysToEpoch, era = quotient(days, 146097), rest = days - 146097 * era,
                       year = (rest - rest / 1460 + rest / 36524 - rest / 146096) / 365;
    return dateInMarchYear(400 * era + year, rest - (365 * year + year / 4 - year / 100));
}

} // namespace osgTreeWind
