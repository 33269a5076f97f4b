// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/DateText.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#define ONLY_C_LOCALE 1 // English names of months in any locale
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <date/date.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>
#include <sstream>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr std::string_view decimalDigits = "0123456789";

using Fields = date::fields<std::chrono::nanoseconds>;

/// The start of a text, parsed by a format.
struct ParsedDate {
    Fields fields;
    std::string zone;
    std::chrono::minutes offset{0};
    std::string_view rest;
};

std::optional<ParsedDate> parseStart(std::string_view text, const char* format) {
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    ParsedDate parsed;
    if (!date::from_stream(stream, format, parsed.fields, &parsed.zone, &parsed.offset))
        return std::nullopt;
    stream.clear(); // of the end of the text
    parsed.rest = text.substr(std::min(static_cast<std::size_t>(stream.tellg()), text.size()));
    return parsed;
}

std::size_t countDigits(std::string_view text) {
    return std::min(text.find_first_not_of(decimalDigits), text.size());
}

/// Seconds since midnight, at most 24:00; empty for a time that does not exist.
std::optional<double> secondsOf(const Fields& fields) {
    const auto& time = fields.tod;
    const std::chrono::duration<double> seconds =
        time.hours() + time.minutes() + time.seconds() + time.subseconds();
    if (time.minutes().count() >= 60 || time.seconds().count() >= 60 || seconds > std::chrono::hours(24))
        return std::nullopt;
    return seconds.count();
}

/// Seconds since 1970 of a day; empty for a day that does not exist, and for years of two digits.
std::optional<double> dayOf(const Fields& fields) {
    if (!fields.ymd.ok() || fields.ymd.year() < date::year(100))
        return std::nullopt;
    return std::chrono::duration<double>(date::sys_days(fields.ymd).time_since_epoch()).count();
}

/// A zone's distance from UTC in seconds: that of "Z", "UTC", "GMT", "+1", "-0930", "UTC+01:00".
std::optional<double> zoneOf(std::string_view text) {
    std::string zone = lower(std::string(text));
    for (const char* utc : {"z", "utc", "gmt"})
        if (zone == utc)
            return 0.0;
    if (zone.rfind("utc", 0) == 0 || zone.rfind("gmt", 0) == 0)
        zone.erase(0, 3);
    if (zone.size() == 6 && zone[3] == ':')
        zone.erase(3, 1);
    const std::size_t digits =
        countDigits(std::string_view(zone).substr(std::min<std::size_t>(1, zone.size())));
    if ((zone[0] != '+' && zone[0] != '-') || digits + 1 != zone.size() || (digits != 2 && digits != 4))
        return std::nullopt;
    const double hours = *parseNumber(zone.substr(1, 2)),
                 minutes = digits == 4 ? *parseNumber(zone.substr(3)) : 0.0;
    if (hours >= 24.0 || minutes >= 60.0)
        return std::nullopt;
    return (zone[0] == '-' ? -60.0 : 60.0) * (60.0 * hours + minutes);
}

/// "15:00" or "15:00:00" for "1500" or "150000".
std::string spreadTime(std::string_view digits) {
    std::string text(digits.substr(0, 2));
    for (std::size_t at = 2; at < digits.size(); at += 2)
        text.append(":").append(digits.substr(at, 2));
    return text;
}

/// Whether a time has seconds after this separator: the library converts an uninitialised value where they
/// are missing.
bool hasSeconds(std::string_view time, char separator) {
    std::size_t at = countDigits(time);
    for (int i = 0; i < 2; ++i) {
        const std::size_t digits =
            at + 1 < time.size() && time[at] == separator ? countDigits(time.substr(at + 1)) : 0;
        if (digits < 1 || digits > 2)
            return false;
        at += 1 + digits;
    }
    return true;
}

/// Reads the time after a date, with its zone. @return seconds since midnight UTC.
std::optional<double> readTimeOfDay(std::string_view text, bool& hasZone) {
    if (text.empty())
        return 0.0;
    const std::size_t start = text.find_first_not_of(text[0] == 'T' || text[0] == 't' ? "Tt" : " ,");
    if (start == 0 || start == std::string_view::npos)
        return std::nullopt;
    std::string time(text.substr(start));
    const std::size_t digits = countDigits(time);
    if (digits == 4 || digits == 6)
        time = spreadTime(std::string_view(time).substr(0, digits)) + time.substr(digits);
    else if (digits < 1 || digits > 2)
        return std::nullopt;
    std::replace(time.begin(), time.end(), ',', '.');
    for (const std::string_view format :
         {"%H:%M:%S", "%H:%M", "%I:%M:%S %p", "%I:%M %p", "%I %p", "%H %M %S", "%H %M", "%Hh%M", "%H"}) {
        if (format.find("%S") != std::string_view::npos && !hasSeconds(time, format[2]))
            continue;
        const std::optional<ParsedDate> parsed = parseStart(time, format.data());
        const std::optional<double> seconds = parsed ? secondsOf(parsed->fields) : std::nullopt;
        if (!seconds)
            continue;
        const std::string_view zone = trimmed(parsed->rest);
        if (zone.empty())
            return seconds;
        if (const std::optional<double> ahead = zoneOf(zone)) {
            hasZone = true;
            return *seconds - *ahead;
        }
    }
    return std::nullopt;
}

/// Formats of a date; two if the order of day and month is not known.
struct DateForm {
    std::string dayFirst, monthFirst;
};

std::vector<DateForm> dateForms() {
    std::vector<DateForm> forms;
    for (const char separator : {'-', '/', '.', ' '}) {
        for (DateForm form : {DateForm{"%Y-%m-%d", ""},
                              {"%d-%m-%Y", "%m-%d-%Y"},
                              {"%d-%b-%Y", ""},
                              {"%b-%d-%Y", ""},
                              {"%Y-%b-%d", ""},
                              {"%d-%m-%y", "%m-%d-%y"},
                              {"%d-%b-%y", ""}}) {
            if (separator == '-' && form.dayFirst == "%d-%m-%y")
                continue; // "17-10-26" may have the year first
            std::replace(form.dayFirst.begin(), form.dayFirst.end(), '-', separator);
            std::replace(form.monthFirst.begin(), form.monthFirst.end(), '-', separator);
            forms.push_back(form);
        }
    }
    forms.push_back({"%b %d, %Y", ""});
    forms.push_back({"%a, %d %b %Y", ""});
    return forms;
}

std::optional<double> readForm(std::string_view text, const std::string& format, bool& hasZone) {
    const std::optional<ParsedDate> parsed = parseStart(text, format.c_str());
    const std::optional<double> day = parsed ? dayOf(parsed->fields) : std::nullopt;
    const std::optional<double> seconds = day ? readTimeOfDay(parsed->rest, hasZone) : std::nullopt;
    return seconds ? std::optional(*day + *seconds) : std::nullopt;
}

} // namespace

DateReadings readDate(std::string_view text) {
    text = trimmed(text);
    std::string spread;
    if (const std::size_t digits = countDigits(text); digits >= 8) {
        if (digits > 14 || digits % 2 != 0)
            return {};
        spread = std::string(text.substr(0, 4))
                     .append("-")
                     .append(text.substr(4, 2))
                     .append("-")
                     .append(text.substr(6, 2));
        if (digits > 8)
            spread += " " + spreadTime(text.substr(8, digits - 8));
        text = spread.append(text.substr(digits));
    }
    static const std::vector<DateForm> forms = dateForms();
    DateReadings readings;
    const auto separator =
        std::find_if_not(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c); });
    for (const DateForm& form : forms) {
        if (separator == text.begin() || separator == text.end() || *separator != form.dayFirst[2])
            continue; // faster than a stream
        readings.dayFirst = readForm(text, form.dayFirst, readings.hasZone);
        readings.monthFirst =
            form.monthFirst.empty() ? readings.dayFirst : readForm(text, form.monthFirst, readings.hasZone);
        if (readings.isRead())
            break;
    }
    return readings;
}

DateReadings readDate(std::string_view text, const std::string& format) {
    const std::optional<ParsedDate> parsed = parseStart(trimmed(text), format.c_str());
    if (!parsed || !parsed->rest.empty())
        return {};
    const std::optional<double> day = dayOf(parsed->fields), seconds = secondsOf(parsed->fields);
    const std::optional<double> zone = parsed->zone.empty() ? 0.0 : zoneOf(parsed->zone);
    if (!day || !seconds || !zone)
        return {};
    const double time = *day + *seconds - std::chrono::duration<double>(parsed->offset).count() - *zone;
    return {time, time, !parsed->zone.empty() || format.find('z') != std::string::npos};
}

std::optional<double> parseDate(std::string_view text) {
    const DateReadings readings = readDate(text);
    return readings.dayFirst == readings.monthFirst ? readings.dayFirst : std::nullopt;
}

std::string isoTimeText(double seconds) {
    constexpr double mostSeconds = 9e11; // about 28,000 years
    if (!(std::abs(seconds) < mostSeconds))
        return {};
    const std::chrono::seconds whole(static_cast<std::int64_t>(std::floor(seconds)));
    return date::format("%FT%TZ", date::sys_seconds(whole));
}

} // namespace osgTreeWind
