// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsWay.h>

#include <osgTreeWind/base/Problem.h>

#include <cmath>

namespace osgTreeWind {

bool CrsWay::go(glm::dvec2& place) const {
    std::vector<glm::dvec2> one{place};
    go(one);
    place = one.front();
    return staysHere() || !std::isnan(place.x);
}

Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& of, const std::string& key) {
    const auto way = CrsWay::between(of, Crs::degrees());
    if (!way)
        return way.problems();
    if (!way.value().go(place) || std::abs(place.x) > 360.0 || std::abs(place.y) > 90.0)
        return keyProblem({}, "its places are none of " + of.name() + "; expected " + key +
                                  " to say of what they are");
    return Crs::utmOf(place);
}

} // namespace osgTreeWind
