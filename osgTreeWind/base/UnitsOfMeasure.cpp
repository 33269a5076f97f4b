// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace osgTreeWind {

namespace {

/// A unit and its names. The first is that in .treewind files.
struct Unit {
    Dimension dimension;
    double size;
    std::vector<std::string_view> names;
};

constexpr double degreesPerRadian = 57.295779513082320876798;

const std::vector<Unit>& units() {
    static const std::vector<Unit> all = {
        {Dimension::Length, 1.0, {"m", "metre", "metres", "meter", "meters", "gpm"}},
        {Dimension::Length, 0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
        {Dimension::Length, 0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
        {Dimension::Length,
         1200.0 / 3937.0,
         {"us-ft", "us survey foot", "us survey feet", "us_survey_foot", "us_survey_feet", "foot_us",
          "ftus"}},
        {Dimension::Length,
         0.3048,
         {"ft", "foot", "feet", "international foot", "international_foot", "international_feet", "ift"}},
        {Dimension::Length, 0.0254, {"in", "inch", "inches"}},
        {Dimension::Speed,
         1.0,
         {"m/s", "m s-1", "m s^-1", "m s**-1", "m s⁻¹", "m·s⁻¹", "ms-1", "meters/second", "metres/second",
          "meters/sec", "mps", "meters per second", "meter/sec", "metre per second", "m/sec"}},
        {Dimension::Speed, 1.0 / 3.6, {"km/h", "km h-1", "kph", "kmh", "kmph", "km/hr"}},
        {Dimension::Speed, 1852.0 / 3600.0, {"kn", "knots", "knot", "kt", "kts", "knoten"}},
        {Dimension::Speed, 0.44704, {"mph", "miles/hour"}},
        {Dimension::Speed, 0.3048, {"ft/s", "ft s-1"}},
        {Dimension::Time, 1.0, {"s", "sec", "secs", "second", "seconds"}},
        {Dimension::Time, 60.0, {"min", "mins", "minute", "minutes"}},
        {Dimension::Time, 3600.0, {"h", "hr", "hrs", "hour", "hours"}},
        {Dimension::Time, 86400.0, {"days", "d", "day"}},
        {Dimension::Time, 604800.0, {"weeks", "week"}},
        {Dimension::Time, 0.001, {"ms"}},
        {Dimension::Direction, 1.0, {"deg", "°", "degree", "degrees"}},
        {Dimension::Direction,
         10.0,
         {"10 deg", "10s deg", "10's deg", "10 degrees", "deg/10", "10deg", "10°", "tens of degrees"}},
        {Dimension::Direction, degreesPerRadian, {"rad", "radian", "radians"}}};
    return all;
}

const Unit* find(Dimension dimension, const std::string& name) {
    const std::string folded = lower(name);
    for (const Unit& unit : units())
        if (unit.dimension == dimension &&
            std::find(unit.names.begin(), unit.names.end(), folded) != unit.names.end())
            return &unit;
    return nullptr;
}

bool isAlphanumeric(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a word begins at `at`, after a separator or in CamelCase.
bool beginsWord(const std::string& name, std::size_t at) {
    return !isAlphanumeric(name[at - 1]) || (std::isupper(static_cast<unsigned char>(name[at])) &&
                                             std::islower(static_cast<unsigned char>(name[at - 1])));
}

} // namespace

std::optional<double> knownUnit(Dimension dimension, const std::string& name) {
    const Unit* const unit = find(dimension, name);
    return unit ? std::optional(unit->size) : std::nullopt;
}

std::string canonicalUnit(Dimension dimension, const std::string& name) {
    const Unit* const unit = find(dimension, name);
    return unit ? std::string(unit->names.front()) : name;
}

std::string expectedUnit(Dimension dimension) {
    constexpr const char* dimensions[] = {"length", "speed", "time", "direction"};
    std::string text = std::string("a unit of ") + dimensions[static_cast<int>(dimension)] + " (", comma;
    for (const Unit& unit : units())
        if (unit.dimension == dimension) {
            text += comma + std::string(unit.names.front());
            comma = ", ";
        }
    return text + ')';
}

std::string unitInName(Dimension dimension, const std::string& column) {
    const std::string name(trimmed(column));
    std::string last;
    for (std::size_t open = 0; (open = name.find_first_of("([", open + 1)) < name.size();) {
        const std::size_t close = std::min(name.find_first_of(")]", open), name.size());
        const std::string unit(trimmed(std::string_view(name).substr(open + 1, close - open - 1)));
        if (find(dimension, unit))
            return unit;
        if (close + 1 == name.size() && unit.find_first_not_of("0123456789") != std::string::npos)
            last = unit;
    }
    if (!last.empty())
        return last;
    constexpr std::size_t minSize = 3; // of words that are hardly anything else
    for (std::size_t at = 1; at < name.size(); ++at) {
        const bool isWord = beginsWord(name, at);
        if ((isWord || (dimension == Dimension::Speed && at + minSize <= name.size())) &&
            find(dimension, name.substr(at)))
            return name.substr(at);
        std::size_t end = at;
        while (end < name.size() && isAlphanumeric(name[end]))
            ++end;
        if (isWord && end - at >= minSize && find(dimension, name.substr(at, end - at)))
            return name.substr(at, end - at);
    }
    return {};
}

} // namespace osgTreeWind
