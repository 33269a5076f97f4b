// SPDX-License-Identifier: MIT
// The functions of Crs and CrsTransform that need PROJ, for the programs that link GDAL. The library uses
// places/MapProgramClient.cpp instead.
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <ogr_srs_api.h>

#include <cmath>
#include <limits>

namespace osgTreeWind {

Result<Crs> Crs::parse(const std::string& text) {
    const Result<GdalCrs> parsed = GdalCrs::parse(text);
    return parsed ? Result<Crs>(parsed.value().crs()) : parsed.problems();
}

bool Crs::isSame(const Crs& other) const {
    if (text() == other.text())
        return true;
    const auto mine = GdalCrs::parse(text()), theirs = GdalCrs::parse(other.text());
    const GdalErrors errors;
    return mine && theirs && OSRIsSame(mine.value().reference(), theirs.value().reference());
}

Result<CrsTransform> CrsTransform::between(const Crs& from, const Crs& to) {
    CrsTransform transform;
    if (from.text() == to.text())
        return transform;
    const auto start = GdalCrs::parse(from.text()), end = GdalCrs::parse(to.text());
    if (!start || !end)
        return (start ? end : start).problems();
    const GdalErrors errors;
    if (OSRIsSame(start.value().reference(), end.value().reference()))
        return transform;
    transform._handle.reset(
        OCTNewCoordinateTransformation(start.value().reference(), end.value().reference()), [](void* made) {
            if (made)
                OCTDestroyCoordinateTransformation(made);
        });
    if (!transform._handle)
        return keyProblem("crs", "no transformation from " + from.name() + " to " + to.name() + ": " +
                                     errors.textOr("PROJ knows none"));
    transform._from = from;
    transform._to = to;
    return transform;
}

/// One by one: PROJ selects the best of several transformations for each place.
void CrsTransform::apply(std::vector<glm::dvec2>& places) const {
    if (isIdentity())
        return;
    const GdalErrors errors;
    for (glm::dvec2& place : places)
        if (!OCTTransform(handle(), 1, &place.x, &place.y, nullptr) || !std::isfinite(place.x) ||
            !std::isfinite(place.y))
            place = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
}

} // namespace osgTreeWind
