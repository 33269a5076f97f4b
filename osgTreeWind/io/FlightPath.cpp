// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/FlightPath.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/RotationAbout.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double speed = 50.0, maxStep = 200.0; // m/s; metres between points
constexpr double inward = 0.6;                  // radians that the camera is turned inward

/// The highest foot in the tile at a place and its neighbours, metres; or else of all tiles.
double highestAt(const ForestTiles& tiles, const glm::dvec2& place) {
    const glm::dvec2 at = glm::floor((place - tiles.corner) / tiles.size);
    double highest = -1e9, any = -1e9;
    for (std::size_t i = 0; i < tiles.tiles.size(); ++i) {
        if (tiles.tiles[i].trees == 0)
            continue;
        const glm::dvec2 off = glm::abs(glm::dvec2(i % tiles.columns, i / tiles.columns) - at);
        const auto high = static_cast<double>(tiles.tiles[i].high);
        any = std::max(any, high);
        if (off.x <= 1.0 && off.y <= 1.0)
            highest = std::max(highest, high);
    }
    return highest > -1e9 ? highest : any;
}

} // namespace

std::string makeFlightPath(const ForestTiles& tiles, const glm::dvec3& origin) {
    const glm::dvec2 size = tiles.size * glm::dvec2(tiles.columns, tiles.rows()),
                     middle = tiles.corner + 0.5 * size, half = glm::max(0.25 * size, 50.0);
    const double turn = glm::two_pi<double>(),
                 length = turn * std::sqrt(0.5 * glm::dot(half, half)); // approximately, metres
    const double radius = std::min(half.x, half.y), clearance = std::clamp(0.8 * radius, 40.0, 70.0),
                 tilt = std::clamp(math::atan(clearance / radius), 0.12, 0.7); // radians downward
    const int steps = std::max(static_cast<int>(std::ceil(length / maxStep)), 24);
    std::string text;
    for (int i = 0; i <= steps; ++i) {
        const double angle = turn * i / steps;
        const glm::dvec2 at = middle + half * glm::dvec2(math::cos(angle), math::sin(angle));
        const double ahead = math::atan2(half.y * math::cos(angle), -half.x * math::sin(angle));
        const glm::dquat rotation = rotationAbout(glm::dvec3(0.0, 0.0, 1.0), ahead + inward - 0.25 * turn) *
                                    rotationAbout(glm::dvec3(1.0, 0.0, 0.0), 0.25 * turn - tilt);
        const glm::dvec3 eye = glm::dvec3(at, highestAt(tiles, at) + clearance) - origin;
        for (const double number : {length / speed * i / steps, eye.x, eye.y, eye.z, rotation.x, rotation.y,
                                    rotation.z, rotation.w})
            text += numberText(number) + ' ';
        text.back() = '\n';
    }
    return text;
}

} // namespace osgTreeWind
