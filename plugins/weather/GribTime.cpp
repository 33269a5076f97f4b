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
    struct Unit {
        int edition, number; // edition 0: both
        double seconds;
    };
    constexpr Unit units[] = {{0, 0, 60.0},     {0, 1, 3600.0},   {0, 2, 86400.0}, {0, 10, 10800.0},
                              {0, 11, 21600.0}, {0, 12, 43200.0}, {1, 13, 900.0},  {1, 14, 1800.0},
                              {1, 254, 1.0},    {2, 13, 1.0}};
    for (const Unit& each : units)
        if (each.number == unit && (each.edition == 0 || each.edition == edition))
            return each.seconds;
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
