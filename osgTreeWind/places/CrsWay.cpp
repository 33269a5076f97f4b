// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsWay.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/GdalErrors.h>

#include <ogr_srs_api.h>

#include <cmath>

namespace osgTreeWind {

Result<CrsWay> CrsWay::between(const Crs& from, const Crs& to) {
    const GdalErrors errors;
    CrsWay way;
    if (from.isSame(to))
        return way;
    way._transformation.reset(OCTNewCoordinateTransformation(from.reference(), to.reference()),
                              [](void* made) { OCTDestroyCoordinateTransformation(made); });
    if (!way._transformation)
        return keyProblem("crs", "no way from " + from.name() + " to " + to.name() + ": " +
                                     errors.textOr("PROJ knows none"));
    return way;
}

bool CrsWay::go(glm::dvec2& place) const {
    if (!_transformation)
        return true;
    const GdalErrors errors;
    return OCTTransform(_transformation.get(), 1, &place.x, &place.y, nullptr) && std::isfinite(place.x) &&
           std::isfinite(place.y);
}

Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& of, const std::string& key) {
    const Result<Crs> degrees = Crs::degrees();
    const auto way = degrees ? CrsWay::between(of, degrees.value()) : degrees.problems();
    if (!way)
        return way.problems();
    if (!way.value().go(place) || std::abs(place.x) > 360.0 || std::abs(place.y) > 90.0)
        return keyProblem({}, "its places are none of " + of.name() + "; expected " + key +
                                  " to say of what they are");
    return Crs::utmOf(place);
}

} // namespace osgTreeWind
