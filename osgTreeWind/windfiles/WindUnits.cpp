// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindUnits.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

namespace osgTreeWind {

namespace {

struct Unit {
    const char* name;
    double value;
};

constexpr Unit speedUnits[] = {
    {"m/s", 1.0}, {"km/h", 1.0 / 3.6}, {"kn", 1852.0 / 3600.0}, {"mph", 0.44704}, {"ft/s", 0.3048}};
constexpr Unit timeUnits[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"days", 86400.0}, {"ms", 0.001}};

template <std::size_t N>
Result<double> valueOf(const Unit (&units)[N], const char* what, const std::string& name) {
    std::string accepted;
    for (const Unit& unit : units) {
        if (name == unit.name)
            return unit.value;
        accepted += (accepted.empty() ? "" : ", ") + std::string(unit.name);
    }
    return fileProblem({}, expectedFound(std::string(what) + " (" + accepted + ")", name));
}

} // namespace

std::string canonicalSpeedUnit(const std::string& text) {
    static const std::pair<const char*, const char*> names[] = {{"m s-1", "m/s"},
                                                                {"m s^-1", "m/s"},
                                                                {"m s**-1", "m/s"},
                                                                {"ms-1", "m/s"},
                                                                {"meters/second", "m/s"},
                                                                {"metres/second", "m/s"},
                                                                {"meters/sec", "m/s"},
                                                                {"mps", "m/s"},
                                                                {"meters per second", "m/s"},
                                                                {"meter/sec", "m/s"},
                                                                {"metre per second", "m/s"},
                                                                {"m/sec", "m/s"},
                                                                {"km h-1", "km/h"},
                                                                {"kph", "km/h"},
                                                                {"knots", "kn"},
                                                                {"knot", "kn"},
                                                                {"kt", "kn"},
                                                                {"kts", "kn"},
                                                                {"miles/hour", "mph"},
                                                                {"ft s-1", "ft/s"}};
    const std::string folded = lower(text);
    for (const auto& [name, unit] : names)
        if (folded == name)
            return unit;
    return text;
}

Result<double> speedUnit(const std::string& name) {
    return valueOf(speedUnits, "a unit of speed", name);
}

Result<double> timeUnit(const std::string& name) {
    return valueOf(timeUnits, "a unit of time", name);
}

} // namespace osgTreeWind
