// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapScale.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Distance in metres of two close places on the WGS 84 ellipsoid, given in degrees.
double metresBetween(const glm::dvec2& a, const glm::dvec2& b) {
    constexpr double semiMajorAxis = 6378137.0, squaredEccentricity = 0.00669437999014;
    const double sine = math::sin(glm::radians(0.5 * (a.y + b.y))),
                 w = 1.0 - squaredEccentricity * sine * sine;
    const double primeVertical = semiMajorAxis / std::sqrt(w), // radii of curvature
        meridian = primeVertical * (1.0 - squaredEccentricity) / w;
    const glm::dvec2 difference = glm::radians(b - a);
    return glm::length(
        glm::dvec2(difference.x * primeVertical * std::sqrt(1.0 - sine * sine), difference.y * meridian));
}

} // namespace

double scaleOfMap(const Crs& map, const glm::dvec2& place) {
    constexpr double h = 100.0; // metres, step of the central differences
    const auto transform = CrsTransform::between(map, Crs::wgs84());
    if (!transform)
        return 1.0;
    std::vector<glm::dvec2> places{place - glm::dvec2(h, 0.0), place + glm::dvec2(h, 0.0),
                                   place - glm::dvec2(0.0, h), place + glm::dvec2(0.0, h)};
    transform.value().apply(places);
    const double east = 2.0 * h / metresBetween(places[0], places[1]),
                 north = 2.0 * h / metresBetween(places[2], places[3]);
    if (!std::isfinite(east) || !std::isfinite(north))
        return 1.0;
    const double scale = std::abs(math::log(east)) > std::abs(math::log(north)) ? east : north;
    return scale < 0.99 || scale > 1.01 ? scale : 1.0;
}

} // namespace osgTreeWind
