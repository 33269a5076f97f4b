// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapScale.h>

#include <osgTreeWind/places/CrsWay.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Metres between two places near each other on the ellipsoid of WGS 84, in degrees.
double metresBetween(const glm::dvec2& a, const glm::dvec2& b) {
    constexpr double equator = 6378137.0, squaredEccentricity = 0.00669437999014;
    const double sine = std::sin(glm::radians(0.5 * (a.y + b.y))),
                 curved = 1.0 - squaredEccentricity * sine * sine;
    const double across = equator / std::sqrt(curved), along = across * (1.0 - squaredEccentricity) / curved;
    const glm::dvec2 apart = glm::radians(b - a);
    return glm::length(glm::dvec2(apart.x * across * std::sqrt(1.0 - sine * sine), apart.y * along));
}

} // namespace

double scaleOfMap(const Crs& map, const glm::dvec2& place) {
    constexpr double reach = 100.0;
    const auto way = CrsWay::between(map, Crs::degrees());
    if (!way)
        return 1.0;
    std::vector<glm::dvec2> places{place - glm::dvec2(reach, 0.0), place + glm::dvec2(reach, 0.0),
                                   place - glm::dvec2(0.0, reach), place + glm::dvec2(0.0, reach)};
    way.value().go(places);
    const double east = 2.0 * reach / metresBetween(places[0], places[1]),
                 north = 2.0 * reach / metresBetween(places[2], places[3]);
    if (!std::isfinite(east) || !std::isfinite(north))
        return 1.0;
    const double scale = std::abs(std::log(east)) > std::abs(std::log(north)) ? east : north;
    return scale < 0.99 || scale > 1.01 ? scale : 1.0;
}

} // namespace osgTreeWind
