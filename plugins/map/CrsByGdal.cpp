// SPDX-License-Identifier: MIT
// Of Crs and CrsWay what PROJ has to know, as the programs have it that link GDAL. In the library
// places/MapsByProgram.cpp stands in place of this.
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsWay.h>

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

Result<CrsWay> CrsWay::between(const Crs& from, const Crs& to) {
    CrsWay way;
    if (from.text() == to.text())
        return way;
    const auto start = GdalCrs::parse(from.text()), end = GdalCrs::parse(to.text());
    if (!start || !end)
        return (start ? end : start).problems();
    const GdalErrors errors;
    if (OSRIsSame(start.value().reference(), end.value().reference()))
        return way;
    way._held.reset(OCTNewCoordinateTransformation(start.value().reference(), end.value().reference()),
                    [](void* made) {
                        if (made)
                            OCTDestroyCoordinateTransformation(made);
                    });
    if (!way._held)
        return keyProblem("crs", "no way from " + from.name() + " to " + to.name() + ": " +
                                     errors.textOr("PROJ knows none"));
    way._from = from;
    way._to = to;
    return way;
}

/// One by one: of several ways PROJ takes for each place the one that suits it.
void CrsWay::go(std::vector<glm::dvec2>& places) const {
    if (staysHere())
        return;
    const GdalErrors errors;
    for (glm::dvec2& place : places)
        if (!OCTTransform(transformation(), 1, &place.x, &place.y, nullptr) || !std::isfinite(place.x) ||
            !std::isfinite(place.y))
            place = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
}

} // namespace osgTreeWind
