// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace osgTreeWind {

/// A unit in metres or seconds, and the names that data files give it. The first name is that in .treewind
/// files.
struct UnitOfMeasure {
    double size;
    std::array<std::string_view, 8> names;
};

inline constexpr UnitOfMeasure unitsOfLength[] = {
    {1.0, {"m", "metre", "metres", "meter", "meters", "gpm"}},
    {0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
    {0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
    {1200.0 / 3937.0,
     {"us-ft", "us survey foot", "us survey feet", "us_survey_foot", "us_survey_feet", "foot_us", "ftus"}},
    {0.3048, {"ft", "foot", "feet", "international foot", "international_foot", "international_feet", "ift"}},
    {0.0254, {"in", "inch", "inches"}}};

inline constexpr UnitOfMeasure unitsOfTime[] = {{1.0, {"s", "sec", "secs", "second", "seconds"}},
                                                {60.0, {"min", "mins", "minute", "minutes"}},
                                                {3600.0, {"h", "hr", "hrs", "hour", "hours"}},
                                                {86400.0, {"d", "day", "days"}},
                                                {604800.0, {"week", "weeks"}}};

/// The size of a named unit; empty if the name is unknown.
template <std::size_t N>
std::optional<double> sizeOfUnit(const UnitOfMeasure (&units)[N], std::string_view name) {
    for (const UnitOfMeasure& unit : units)
        if (!name.empty() && std::find(unit.names.begin(), unit.names.end(), name) != unit.names.end())
            return unit.size;
    return std::nullopt;
}

} // namespace osgTreeWind
