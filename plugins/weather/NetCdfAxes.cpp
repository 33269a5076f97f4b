// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfAxes.h>

#include <plugins/weather/Words.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>
#include <osgTreeWind/places/LongitudeWrap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

std::string unitOf(const NetCdfArray& array) {
    return array.unit.empty() ? array.text("units") : array.unit;
}

/// Metres in a unit of length; empty for other units.
std::optional<double> metresIn(const std::string& unit) {
    if (isOneOf(unit, {"km", "kilometer", "kilometers", "kilometre", "kilometres"}))
        return 1000.0;
    return unit.empty() ? 1.0 : knownUnit(Dimension::Length, unit);
}

bool isTimeUnit(const std::string& unit) {
    return unit.find(" since ") != std::string::npos || knownUnit(Dimension::Time, unit);
}

NetCdfMeasure byStandardName(const std::string& name) {
    if (isOneOf(name, {"longitude", "grid_longitude"}))
        return NetCdfMeasure::Longitude;
    if (isOneOf(name, {"latitude", "grid_latitude"}))
        return NetCdfMeasure::Latitude;
    if (name == "air_pressure")
        return NetCdfMeasure::Pressure;
    if (startsWithAny(name, {"atmosphere_", "model_level"}))
        return NetCdfMeasure::Model;
    return name == "time" ? NetCdfMeasure::Time : NetCdfMeasure::None;
}

NetCdfMeasure byUnit(const std::string& unit, const std::string& name) {
    if (startsWithAny(unit, {"degrees_e", "degree_e", "degreee", "degreese"}))
        return NetCdfMeasure::Longitude;
    if (startsWithAny(unit, {"degrees_n", "degree_n", "degreen", "degreesn"}))
        return NetCdfMeasure::Latitude;
    if (isOneOf(unit, {"pa", "hpa", "mbar", "mb", "millibar", "millibars", "hectopascal"}))
        return NetCdfMeasure::Pressure;
    if (isTimeUnit(unit))
        return NetCdfMeasure::Time;
    const bool isAngle = unit.empty() || startsWithAny(unit, {"deg"});
    if (isAngle && startsWithAny(name, {"lon", "rlon", "grid_lon"}))
        return NetCdfMeasure::Longitude;
    if (isAngle && startsWithAny(name, {"lat", "rlat", "grid_lat"}))
        return NetCdfMeasure::Latitude;
    if (startsWithAny(name, {"isobaric", "pressure", "plev"}))
        return NetCdfMeasure::Pressure;
    if (startsWithAny(name, {"hybrid", "sigma", "model_level", "ml"}) ||
        isOneOf(unit, {"1", "level", "sigma_level"}))
        return NetCdfMeasure::Model;
    return !unit.empty() && metresIn(unit) ? NetCdfMeasure::Metres : NetCdfMeasure::None;
}

bool isLevel(NetCdfMeasure measure) {
    return measure == NetCdfMeasure::Pressure || measure == NetCdfMeasure::Model;
}

/// The role that attributes and units give a dimension; null if they do not.
std::optional<std::size_t>* explicitRole(const NetCdfFile& file, const NetCdfDimension& dimension,
                                         NetCdfRoles& roles) {
    const std::string name = lower(dimension.name);
    const NetCdfMeasure measure = measureOf(file, dimension);
    const NetCdfFile::Array found = file.array(dimension.coordinates);
    const std::string axis = found ? found->text("axis") : "",
                      standard = found ? found->text("standard_name") : "";
    if (name == "expver")
        return &roles.version;
    if (measure == NetCdfMeasure::Longitude || axis == "X" || standard == "projection_x_coordinate")
        return &roles.x;
    if (measure == NetCdfMeasure::Latitude || axis == "Y" || standard == "projection_y_coordinate")
        return &roles.y;
    if (isLevel(measure) || axis == "Z" || isOneOf(standard, {"height", "altitude"}))
        return &roles.level;
    if (measure == NetCdfMeasure::Time || dimension.isTime || (!name.empty() && name[0] == 't'))
        return &roles.time;
    return nullptr;
}

} // namespace

NetCdfMeasure measureOf(const NetCdfArray& coordinates) {
    const NetCdfMeasure stated = byStandardName(coordinates.text("standard_name"));
    return stated != NetCdfMeasure::None ? stated
                                         : byUnit(lower(unitOf(coordinates)), lower(coordinates.name));
}

NetCdfMeasure measureOf(const NetCdfFile& file, const NetCdfDimension& dimension) {
    const NetCdfFile::Array found = file.array(dimension.coordinates);
    return found ? measureOf(*found) : NetCdfMeasure::None;
}

NetCdfRoles rolesOf(const NetCdfFile& file, const NetCdfArray& array) {
    NetCdfRoles roles;
    std::vector<std::size_t> unknown; // innermost first
    for (std::size_t d = array.dimensions.size(); d-- > 0;) {
        std::optional<std::size_t>* const role = explicitRole(file, array.dimensions[d], roles);
        if (role && !*role)
            *role = d;
        else
            unknown.push_back(d);
    }
    for (const std::size_t d : unknown) {
        const NetCdfDimension& dimension = array.dimensions[d];
        const bool isHeight = startsWithAny(lower(dimension.name), {"z", "lev", "h", "alt", "k", "bottom"}) ||
                              measureOf(file, dimension) == NetCdfMeasure::Metres;
        if (!roles.x)
            roles.x = d;
        else if (!roles.y)
            roles.y = d;
        else if (!roles.level && isHeight)
            roles.level = d;
    }
    return roles;
}

std::vector<double> coordinatesOf(NetCdfFile& file, const NetCdfDimension& dimension) {
    const NetCdfFile::Array found = file.array(dimension.coordinates);
    if (!file.good() || !found)
        return {};
    const NetCdfMeasure measure = measureOf(*found);
    double scale = 1.0;
    if (measure == NetCdfMeasure::None || measure == NetCdfMeasure::Metres) {
        const std::string unit = unitOf(*found);
        if (const auto metres = metresIn(lower(unit)))
            scale = *metres;
        else
            file.fail(found->name, expectedFound("coordinates in m, km, feet or degrees", unit));
    }
    std::vector<double> numbers = file.coordinates(*found);
    for (double& number : numbers)
        number *= scale;
    return numbers;
}

NetCdfAxis axisOf(NetCdfFile& file, const NetCdfDimension& dimension) {
    NetCdfAxis axis{dimension.name, {}, measureOf(file, dimension)};
    std::vector<double> at = coordinatesOf(file, dimension);
    axis.points.count = dimension.size;
    if (at.size() != dimension.size || at.empty() || at.size() > 100000) {
        file.fail(dimension.name, "expected coordinates of this dimension, 1 to 100000 of them");
        return axis;
    }
    if (axis.measure == NetCdfMeasure::Longitude) {
        axis.points.period = 360.0;
        for (std::size_t i = 1; i < at.size(); ++i) // 179, 180, -179
            at[i] += longitudeWrap(at[i], at[i - 1]);
    }
    const double most = axis.measure == NetCdfMeasure::Latitude    ? 90.001
                        : axis.measure == NetCdfMeasure::Longitude ? 1080.0
                                                                   : 1e9;
    axis.points.first = at.front();
    axis.points.step = at.size() > 1 ? (at.back() - at.front()) / static_cast<double>(at.size() - 1) : 1.0;
    const double step = std::abs(axis.points.step);
    const NetCdfFile::Array found = file.array(dimension.coordinates);
    const double rounding = found && found->is32BitFloat() ? std::numeric_limits<float>::epsilon() : 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double even = at.front() + axis.points.step * static_cast<double>(i);
        if (std::abs(at[i]) > most)
            file.fail(dimension.name, "expected coordinates of at most " + numberText(std::floor(most)) +
                                          ", found " + numberText(at[i]));
        if (!(std::abs(at[i] - even) <= 0.01 * step + rounding * std::abs(at[i])) || !(step > 0.0))
            file.fail(dimension.name, "expected evenly spaced coordinates, found " + numberText(at[i]) +
                                          " at index " + std::to_string(i) + " instead of " +
                                          numberText(even));
    }
    return axis;
}

NetCdfMatch matchOf(const NetCdfAxis& a, const NetCdfAxis& b) {
    if (a.name == b.name)
        return NetCdfMatch::Same;
    const double step = a.points.step;
    if (a.isDegrees() != b.isDegrees() || a.points.count < 2 || b.points.count < 2)
        return a.points.count == b.points.count && std::abs(a.points.first - b.points.first) < 1e-6
                   ? NetCdfMatch::Same
                   : NetCdfMatch::Neither;
    if (std::abs(std::abs(b.points.step) - std::abs(step)) *
            static_cast<double>(std::max(a.points.count, b.points.count)) >
        0.05 * std::abs(step))
        return NetCdfMatch::Neither;
    const double apart = (b.points.first - a.points.first) / step, off = std::abs(apart - std::round(apart));
    if (std::abs(apart) < 0.02 && a.points.count == b.points.count && b.points.step * step > 0.0)
        return NetCdfMatch::Same;
    return std::abs(off - 0.5) < 0.02 ? NetCdfMatch::Midway : NetCdfMatch::Neither;
}

NetCdfInterpolation interpolationBetween(const std::vector<double>& coordinates,
                                         const std::vector<double>& targets) {
    const double sign = coordinates.size() > 1 && coordinates.back() < coordinates.front() ? -1.0 : 1.0;
    std::vector<double> upward;
    for (const double coordinate : coordinates)
        upward.push_back(sign * coordinate);
    const std::size_t last = upward.size() - 1;
    std::vector<std::size_t> lower;
    NetCdfInterpolation places;
    for (const double target : targets) {
        const auto above = std::upper_bound(upward.begin(), upward.end(), sign * target);
        const std::size_t at =
            above == upward.begin() ? 0 : static_cast<std::size_t>(above - upward.begin()) - 1;
        lower.push_back(at);
        const double step = at < last ? upward[at + 1] - upward[at] : 0.0;
        places.fraction.push_back(
            step > 0.0 ? static_cast<float>(std::clamp((sign * target - upward[at]) / step, 0.0, 1.0))
                       : 0.0f);
    }
    const auto [low, high] = std::minmax_element(lower.begin(), lower.end());
    for (std::size_t i = *low; i <= std::min(*high + 1, last); ++i)
        places.indices.push_back(i);
    for (const std::size_t at : lower)
        places.lower.push_back(at - *low);
    return places;
}

std::vector<float> interpolate(const std::vector<float>& numbers, std::size_t stride,
                               const NetCdfInterpolation& places) {
    if (places.lower.empty())
        return numbers;
    const std::size_t count = places.indices.size(), blocks = numbers.size() / (count * stride);
    std::vector<float> interpolated;
    interpolated.reserve(blocks * places.lower.size() * stride);
    for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t i = 0; i < places.lower.size(); ++i) {
            const std::size_t low = places.lower[i], high = std::min(low + 1, count - 1);
            const float fraction = places.fraction[i];
            for (std::size_t k = 0; k < stride; ++k) {
                const float a = numbers[(block * count + low) * stride + k],
                            b = numbers[(block * count + high) * stride + k];
                interpolated.push_back(std::isnan(a) ? b : std::isnan(b) ? a : a + fraction * (b - a));
            }
        }
    return interpolated;
}

} // namespace osgTreeWind
