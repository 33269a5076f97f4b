// SPDX-License-Identifier: MIT
#include <plugins/weather/GribTime.h>

#include <osgTreeWind/base/IsoTime.h>

#include <array>
#include <cstdio>
#include <ctime>

namespace osgTreeWind::GribTime {

std::optional<double> secondsOf(const Date& date) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02dZ", date.year, date.month, date.day,
                  date.hour, date.minute, date.second);
    return parseIsoTime(text.data());
}

std::optional<double> secondsOfUnit(int edition, int unit) {
    constexpr double minute = 60.0, hour = 3600.0, day = 86400.0;
    switch (unit) {
    case 0:
        return minute;
    case 1:
        return hour;
    case 2:
        return day;
    case 10:
        return 3.0 * hour;
    case 11:
        return 6.0 * hour;
    case 12:
        return 12.0 * hour;
    default:
        break;
    }
    if (edition == 1 && unit == 13)
        return 15.0 * minute;
    if (edition == 1 && unit == 14)
        return 30.0 * minute;
    if (unit == (edition == 1 ? 254 : 13))
        return 1.0;
    return std::nullopt;
}

std::string text(double seconds) {
    const auto whole = static_cast<std::time_t>(seconds);
    std::tm parts{};
    std::array<char, 80> written{};
    if (!gmtime_r(&whole, &parts) ||
        std::strftime(written.data(), written.size(), "%Y-%m-%dT%H:%M:%SZ", &parts) == 0)
        return {};
    return written.data();
}

} // namespace osgTreeWind::GribTime
