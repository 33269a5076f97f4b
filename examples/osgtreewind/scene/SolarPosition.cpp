// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/SolarPosition.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/trigonometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

double refraction(double elevation) {
    if (elevation < -0.56)
        return 0.0;
    return 3.51561 * (0.1594 + elevation * (0.0196 + 0.00002 * elevation)) /
           (1.0 + elevation * (0.505 + 0.0845 * elevation));
}

} // namespace

SolarPosition::SolarPosition(double time, const glm::dvec2& longitudeLatitude) {
    const double days = (time - 946728000.0) / 86400.0; // since 2000-01-01T12:00Z
    const double anomaly = glm::radians(357.528 + 0.9856003 * days);
    const double longitude = glm::radians(280.460 + 0.9856474 * days + 1.915 * math::sin(anomaly) +
                                          0.020 * math::sin(2.0 * anomaly)); // along the ecliptic
    const double obliquity = glm::radians(23.439 - 0.0000004 * days);
    const double ascension = math::atan2(math::cos(obliquity) * math::sin(longitude), math::cos(longitude));
    const double declination = math::asin(math::sin(obliquity) * math::sin(longitude));

    const double siderealTime = glm::radians(280.46062 + 360.9856474 * days + longitudeLatitude.x);
    const double hourAngle = siderealTime - ascension, latitude = glm::radians(longitudeLatitude.y);
    const double north = math::sin(declination) * math::cos(latitude) -
                         math::cos(declination) * math::sin(latitude) * math::cos(hourAngle),
                 east = -math::cos(declination) * math::sin(hourAngle),
                 up = math::sin(declination) * math::sin(latitude) +
                      math::cos(declination) * math::cos(latitude) * math::cos(hourAngle);
    azimuth = std::fmod(glm::degrees(math::atan2(east, north)) + 360.0, 360.0);
    elevation = glm::degrees(math::atan2(up, math::hypot(north, east)));
    elevation += refraction(elevation);
}

} // namespace osgTreeWind
