// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/LightOptions.h>

#include <examples/osgtreewind/scene/SolarPosition.h>
#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/Number.h>

#include <CLI/CLI.hpp>

#include <osg/Math>
#include <osg/Vec3d>

#include <cmath>
#include <map>
#include <optional>

namespace {

using namespace osgTreeWind;

/// "A,B", within ±`most`.
std::optional<glm::dvec2> parsePair(const std::string& text, const glm::dvec2& most) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        return {};
    const auto first = parseNumber(text.substr(0, comma)), second = parseNumber(text.substr(comma + 1));
    if (!first || !second || std::abs(*first) > most.x || std::abs(*second) > most.y)
        return {};
    return glm::dvec2(*first, *second);
}

/// Azimuth and elevation, degrees.
std::optional<glm::dvec2> parsePosition(const std::string& text) {
    const std::size_t at = text.find('@');
    if (at == std::string::npos)
        return parsePair(text, {360.0, 90.0});
    const auto time = parseIsoTime(text.substr(0, at));
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
        throw CLI::ValidationError("--sun",
                                   "expected the sun above the horizon, found it at an elevation of " +
                                       numberText(std::round(10.0 * sun->y) / 10.0) + " degrees");
    const double azimuth = osg::DegreesToRadians(sun->x), elevation = osg::DegreesToRadians(sun->y);
    return osg::Vec3(osg::Vec3d(std::sin(azimuth) * std::cos(elevation),
                                std::cos(azimuth) * std::cos(elevation), std::sin(elevation)));
}

} // namespace

void addSunOption(CLI::App& command, osg::Vec3& toSun) {
    command.add_option_function<std::string>(
        "--sun", [&toSun](const std::string& text) { toSun = parseSun(text); },
        "Where the sun stands: AZIMUTH,ELEVATION in degrees, clockwise from north (+y), or when and where "
        "the\n"
        "day is: TIME@LATITUDE,LONGITUDE as in 2026-07-01T18:00Z@52.5,13.4; half way up in the south-east "
        "when\n"
        "not given");
}

void addShadowsOption(CLI::App& command, Shadows& shadows) {
    static const std::map<std::string, Shadows> names{
        {"on", Shadows::On}, {"soft", Shadows::Soft}, {"off", Shadows::Off}};
    command
        .add_option_function<std::string>(
            "--shadows", [&shadows](const std::string& name) { shadows = names.at(name); },
            "on: on ground and trees, and they move with the trees; soft: silhouettes on the ground, which\n"
            "lean with the trees; a world has none of these")
        ->check(CLI::IsMember({"on", "soft", "off"}))
        ->default_str("soft");
}
