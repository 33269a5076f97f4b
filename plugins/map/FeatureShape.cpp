// SPDX-License-Identifier: MIT
#include <plugins/map/FeatureShape.h>

#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <ogr_api.h>

#include <cmath>

namespace osgTreeWind {

namespace {

using Geometry = std::unique_ptr<void, decltype(&OGR_G_DestroyGeometry)>;

Diagnostic problem(const std::string& message) {
    return keyProblem("", message);
}

Result<VectorPlace> placeOfPoint(OGRGeometryH point, const CrsWay& way) {
    VectorPlace place;
    glm::dvec2 flat{OGR_G_GetX(point, 0), OGR_G_GetY(point, 0)};
    place.position.z = OGR_G_GetZ(point, 0);
    place.hasHeight = OGR_G_Is3D(point);
    if (!std::isfinite(flat.x) || !std::isfinite(flat.y) || !std::isfinite(place.position.z))
        return problem("expected finite coordinates");
    const std::string was = numberText(flat.x) + ", " + numberText(flat.y);
    if (!way.go(flat))
        return problem("the place (" + was + ") cannot be brought into the crs of the forest");
    place.position.x = flat.x, place.position.y = flat.y;
    return place;
}

/// Of all its points, and those of its parts.
bool isFinite(OGRGeometryH geometry) {
    for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i)
        if (!isFinite(OGR_G_GetGeometryRef(geometry, i)))
            return false;
    for (int i = 0; i < OGR_G_GetPointCount(geometry); ++i)
        if (!std::isfinite(OGR_G_GetX(geometry, i)) || !std::isfinite(OGR_G_GetY(geometry, i)))
            return false;
    return true;
}

/// The centroid and the extents of what is given in any system.
Result<VectorPlace> placeOfOutline(OGRGeometryH given, const CrsWay& way) {
    const GdalErrors errors;
    const Geometry outline(OGR_G_GetLinearGeometry(given, 0.0, nullptr), &OGR_G_DestroyGeometry),
        centre(OGR_G_CreateGeometry(wkbPoint), &OGR_G_DestroyGeometry);
    if (way.transformation() && OGR_G_Transform(outline.get(), way.transformation()) != OGRERR_NONE)
        return problem("its outline cannot be brought into the crs of the forest");
    OGREnvelope box{};
    OGR_G_GetEnvelope(outline.get(), &box);
    const double east = box.MaxX - box.MinX, north = box.MaxY - box.MinY;
    if (!isFinite(outline.get()))
        return problem("expected finite coordinates");
    if (OGR_G_Centroid(outline.get(), centre.get()) != OGRERR_NONE)
        return problem("its outline has no middle: " + errors.textOr("GEOS finds none"));
    VectorPlace place;
    place.position = {OGR_G_GetX(centre.get(), 0), OGR_G_GetY(centre.get(), 0), 0.0};
    if (!(std::abs(place.position.x - 0.5 * (box.MinX + box.MaxX)) <= 0.5 * east &&
          std::abs(place.position.y - 0.5 * (box.MinY + box.MaxY)) <= 0.5 * north))
        return problem("its outline crosses itself: the middle is outside");
    place.width = 0.5 * (east + north);
    return place;
}

} // namespace

Result<VectorPlace> placeOf(void* geometry, const CrsWay& way) {
    if (!geometry || OGR_G_IsEmpty(geometry))
        return problem("it has no geometry");
    switch (wkbFlatten(OGR_G_GetGeometryType(geometry))) {
    case wkbPoint:
        return placeOfPoint(geometry, way);
    case wkbMultiPoint:
    case wkbGeometryCollection:
        if (OGR_G_GetGeometryCount(geometry) == 1)
            return placeOf(OGR_G_GetGeometryRef(geometry, 0), way);
        break;
    case wkbPolygon:
    case wkbMultiPolygon:
    case wkbCurvePolygon:
    case wkbMultiSurface:
        return placeOfOutline(geometry, way);
    default:
        break;
    }
    return problem(std::string("expected a point or the outline of a crown, found ") +
                   OGR_G_GetGeometryName(geometry));
}

} // namespace osgTreeWind
