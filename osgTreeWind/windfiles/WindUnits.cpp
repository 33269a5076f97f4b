// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindUnits.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

namespace osgTreeWind {

namespace {

struct Unit {
    const char* name;
    double value;
};

constexpr Unit speedUnits[] = {
    {"m/s", 1.0}, {"km/h", 1.0 / 3.6}, {"kn", 1852.0 / 3600.0}, {"mph", 0.44704}, {"ft/s", 0.3048}};
constexpr Unit timeUnits[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}};

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

Result<double> speedUnit(const std::string& name) {
    return valueOf(speedUnits, "a unit of speed", name);
}

Result<double> timeUnit(const std::string& name) {
    return valueOf(timeUnits, "a unit of time", name);
}

} // namespace osgTreeWind
