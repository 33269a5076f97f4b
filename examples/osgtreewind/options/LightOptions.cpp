// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/LightOptions.h>

#include <examples/osgtreewind/scene/SolarPosition.h>
#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/PortableMath.h>

#include <CLI/CLI.hpp>

#include <osg/Math>
#include <osg/Vec3d>

#include <cmath>
#include <iostream>
#include <optional>

namespace {

using namespace osgTreeWind;

/// Parses "A,B" with |A| <= limit.x and |B| <= limit.y.
std::optional<glm::dvec2> parsePair(const std::string& text, const glm::dvec2& limit) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        return {};
    const auto first = parseNumber(text.substr(0, comma)), second = parseNumber(text.substr(comma + 1));
    if (!first || !second || std::abs(*first) > limit.x || std::abs(*second) > limit.y)
        return {};
    return glm::dvec2(*first, *second);
}

/// Azimuth and elevation of the sun, degrees.
std::optional<glm::dvec2> parsePosition(const std::string& text) {
    const std::size_t at = text.find('@');
    if (at == std::string::npos)
        return parsePair(text, {360.0, 90.0});
    const auto time = parseDate(text.substr(0, at));
    const auto place = parsePair(text.substr(at + 1), {90.0, 180.0});
    if (!time || !place)
        return {};
    const SolarPosition sun(*time, {place->y, place->x});
    return glm::dvec2(sun.azimuth, sun.elevation);
}

osg::Vec3 parseSun(const std::string& text) {
    const auto sun = parsePosition(text);
    if (!sun)
        throw CLI::ValidationError(
            "--sun", expectedFound("AZIMUTH,ELEVATION in degrees or TIME@LATITUDE,LONGITUDE, as in "
                                   "2026-07-01T18:00Z@52.5,13.4",
                                   text));
    if (!(sun->y > 0.0))
        throw CLI::ValidationError("--sun", "expected the sun above the horizon, found an elevation of " +
                                                numberText(std::round(10.0 * sun->y) / 10.0) + " degrees");
    const double azimuth = osg::DegreesToRadians(sun->x), elevation = osg::DegreesToRadians(sun->y);
    return osg::Vec3(osg::Vec3d(math::sin(azimuth) * math::cos(elevation),
                                math::cos(azimuth) * math::cos(elevation), math::sin(elevation)));
}

} // namespace

void addLightOptions(CLI::App& command, LightOptions& options) {
    command.add_option_function<std::string>(
        "--sun", [&options](const std::string& text) { options.toSun = parseSun(text); },
        "Position of the sun: AZIMUTH,ELEVATION in degrees (azimuth clockwise from north, +y), or "
        "TIME@LATITUDE,LONGITUDE such as 2026-07-01T18:00Z@52.5,13.4 (default: south-east, 48 degrees high)");
    command
        .add_option_function<std::string>(
            "--sky",
            [&options](const std::string& text) {
                options.weather = text == "fair" ? Weather::Fair : Weather::Overcast;
            },
            "Weather: fair (blue sky with some clouds) or overcast (grey sky, no visible shadows)")
        ->check(CLI::IsMember({"fair", "overcast"}))
        ->default_str("fair");
    command
        .add_option_function<std::string>(
            "--shadows",
            [&options](const std::string& text) {
                if (text == "soft")
                    std::cerr << "--shadows soft: note: shadows are on; soft ones are gone\n";
                options.shadows = text != "off";
            },
            "Shadows of trees on ground and trees: on or off (default: on, but off in worlds)")
        ->check(CLI::IsMember({"on", "off", "soft"}));
}
