// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsTransform.h>

#include <osgTreeWind/base/Problem.h>

#include <cmath>

namespace osgTreeWind {

bool CrsTransform::apply(glm::dvec2& place) const {
    std::vector<glm::dvec2> one{place};
    apply(one);
    place = one.front();
    return isIdentity() || !std::isnan(place.x);
}

std::optional<glm::dvec2> longitudeLatitudeOf(glm::dvec2 place, const Crs& crs) {
    const auto transform = CrsTransform::between(crs, Crs::wgs84());
    return transform && transform.value().apply(place) ? std::optional(place) : std::nullopt;
}

Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& crs, const std::string& key) {
    const auto transform = CrsTransform::between(crs, Crs::wgs84());
    if (!transform)
        return transform.problems();
    if (!transform.value().apply(place) || std::abs(place.x) > 360.0 || std::abs(place.y) > 90.0)
        return keyProblem({}, "its coordinates are not valid in " + crs.name() + "; expected " + key +
                                  " to state their system");
    return Crs::utmOf(place);
}

} // namespace osgTreeWind
