// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/IsoTime.h>

#include <osgTreeWind/base/Number.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace osgTreeWind {

namespace {

constexpr std::string_view decimalDigits = "0123456789";

/// Whether the text matches a pattern in which 0 stands for any digit, and T for that letter or a blank.
bool matchesPattern(std::string_view text, std::string_view pattern) {
    return std::equal(text.begin(), text.end(), pattern.begin(), pattern.end(), [](char c, char expected) {
        const std::string_view choices = expected == '0'   ? decimalDigits
                                         : expected == 'T' ? "Tt "
                                                           : std::string_view(&expected, 1);
        return choices.find(c) != std::string_view::npos;
    });
}

int parseDigits(std::string_view digits) {
    int whole = 0;
    for (const char digit : digits)
        whole = 10 * whole + (digit - '0');
    return whole;
}

/// Parses "HH:MM" to minutes; empty for a time that does not exist.
std::optional<int> minutesOf(std::string_view text) {
    const int hour = parseDigits(text.substr(0, 2)), minute = parseDigits(text.substr(3, 2));
    return hour < 24 && minute < 60 ? std::optional(60 * hour + minute) : std::nullopt;
}

/// Parses "SS" or "SS.S".
std::optional<double> secondsOf(std::string_view text) {
    const bool isWhole = matchesPattern(text, "00");
    if (!isWhole && (!matchesPattern(text.substr(0, 3), "00.") || text.size() == 3 ||
                     text.find_first_not_of(decimalDigits, 3) != std::string_view::npos))
        return std::nullopt;
    const std::optional<double> seconds = parseNumber(text);
    return seconds && parseDigits(text.substr(0, 2)) < 60 ? seconds : std::nullopt;
}

} // namespace

std::optional<double> parseIsoTime(std::string_view text) {
    if (!matchesPattern(text.substr(0, 16), "0000-00-00T00:00"))
        return std::nullopt;
    std::tm date{};
    date.tm_year = parseDigits(text.substr(0, 4)) - 1900;
    date.tm_mon = parseDigits(text.substr(5, 2)) - 1;
    const int day = date.tm_mday = parseDigits(text.substr(8, 2)), month = date.tm_mon;
    const std::time_t midnight = timegm(&date);
    const bool exists = date.tm_mday == day && date.tm_mon == month && date.tm_year > -1900;
    const std::optional<int> minutes = minutesOf(text.substr(11));

    std::string_view rest = text.substr(16);
    std::optional<double> seconds = 0.0;
    if (rest.substr(0, 1) == ":") {
        const std::size_t end = std::min(rest.find_first_of("Zz+-"), rest.size());
        seconds = secondsOf(rest.substr(1, end - 1));
        rest.remove_prefix(end);
    }
    std::optional<int> zone = 0;
    if (matchesPattern(rest, "+00:00") || matchesPattern(rest, "-00:00"))
        zone = minutesOf(rest.substr(1));
    else if (!rest.empty() && rest != "Z" && rest != "z")
        return std::nullopt;
    if (!exists || !minutes || !seconds || !zone)
        return std::nullopt;
    return static_cast<double>(midnight) + 60.0 * (*minutes - (rest.substr(0, 1) == "-" ? -*zone : *zone)) +
           *seconds;
}

std::string isoTimeText(double seconds) {
    const auto whole = static_cast<std::time_t>(std::floor(seconds));
    std::tm date{};
    char text[80];
    if (!gmtime_r(&whole, &date) || std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &date) == 0)
        return {};
    return text;
}

} // namespace osgTreeWind
