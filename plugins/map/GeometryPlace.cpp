// SPDX-License-Identifier: MIT
#include <plugins/map/GeometryPlace.h>

#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <glm/gtc/constants.hpp>

#include <cpl_json.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogr_api.h>

#include <cmath>
#include <cstring>
#include <memory>

namespace osgTreeWind {

namespace {

using Geometry = std::unique_ptr<void, decltype(&OGR_G_DestroyGeometry)>;

Diagnostic problem(const std::string& message) {
    return keyProblem("", message);
}

Result<VectorPlace> placeOfPoint(OGRGeometryH point, const CrsTransform& transform) {
    VectorPlace place;
    glm::dvec2 flat{OGR_G_GetX(point, 0), OGR_G_GetY(point, 0)};
    place.position.z = OGR_G_GetZ(point, 0);
    place.hasHeight = OGR_G_Is3D(point);
    if (!std::isfinite(flat.x) || !std::isfinite(flat.y))
        return problem("expected finite coordinates");
    const std::string was = numberText(flat.x) + ", " + numberText(flat.y);
    if (!transform.apply(flat))
        return problem("the place (" + was + ") cannot be transformed to the crs of the forest");
    place.position.x = flat.x, place.position.y = flat.y;
    return place;
}

/// Whether all points of a geometry and of its parts are finite.
bool isFinite(OGRGeometryH geometry) {
    for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i)
        if (!isFinite(OGR_G_GetGeometryRef(geometry, i)))
            return false;
    for (int i = 0; i < OGR_G_GetPointCount(geometry); ++i)
        if (!std::isfinite(OGR_G_GetX(geometry, i)) || !std::isfinite(OGR_G_GetY(geometry, i)))
            return false;
    return true;
}

/// The centroid of an outline, and the width of the circle of the same area.
Result<VectorPlace> placeOfOutline(OGRGeometryH given, const CrsTransform& transform) {
    const GdalErrors errors;
    const Geometry outline(OGR_G_GetLinearGeometry(given, 0.0, nullptr), &OGR_G_DestroyGeometry),
        centre(OGR_G_CreateGeometry(wkbPoint), &OGR_G_DestroyGeometry);
    if (transform.handle() && OGR_G_Transform(outline.get(), transform.handle()) != OGRERR_NONE)
        return problem("its outline cannot be transformed to the crs of the forest");
    OGREnvelope box{};
    OGR_G_GetEnvelope(outline.get(), &box);
    const double east = box.MaxX - box.MinX, north = box.MaxY - box.MinY;
    if (!isFinite(outline.get()))
        return problem("expected finite coordinates");
    if (OGR_G_Centroid(outline.get(), centre.get()) != OGRERR_NONE)
        return problem("its outline has no centroid: " + errors.textOr("GEOS finds none"));
    VectorPlace place;
    place.position = {OGR_G_GetX(centre.get(), 0), OGR_G_GetY(centre.get(), 0), 0.0};
    if (!(std::abs(place.position.x - 0.5 * (box.MinX + box.MaxX)) <= 0.5 * east &&
          std::abs(place.position.y - 0.5 * (box.MinY + box.MaxY)) <= 0.5 * north))
        return problem("its outline crosses itself: the centroid is outside");
    place.width = 2.0 * std::sqrt(OGR_G_Area(outline.get()) / glm::pi<double>());
    return place;
}

Result<VectorPlace> placeOf(OGRGeometryH geometry, const CrsTransform& transform) {
    if (!geometry || OGR_G_IsEmpty(geometry))
        return problem("it has no geometry");
    switch (wkbFlatten(OGR_G_GetGeometryType(geometry))) {
    case wkbPoint:
        return placeOfPoint(geometry, transform);
    case wkbMultiPoint:
    case wkbGeometryCollection:
        if (OGR_G_GetGeometryCount(geometry) == 1)
            return placeOf(OGR_G_GetGeometryRef(geometry, 0), transform);
        break;
    case wkbPolygon:
    case wkbMultiPolygon:
    case wkbCurvePolygon:
    case wkbMultiSurface:
        return placeOfOutline(geometry, transform);
    default:
        break;
    }
    return problem(std::string("expected a point or the outline of a crown, found ") +
                   OGR_G_GetGeometryName(geometry));
}

/// Hexadecimal WKB or EWKB. @param srid of EWKB.
OGRGeometryH parseWkb(const std::string& text, std::int32_t& srid) {
    int size = 0;
    const std::unique_ptr<GByte, decltype(&VSIFree)> bytes(CPLHexToBinary(text.c_str(), &size), &VSIFree);
    std::string wkb(reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size));
    constexpr std::size_t typeAt = 1, sridAt = 5, sridEnd = 9;
    if (wkb.size() < sridEnd)
        return nullptr;
    const bool isLittle = wkb[0] == 1;
    char& flags = wkb[isLittle ? typeAt + 3 : typeAt];
    constexpr char hasSrid = 0x20;
    if (flags & hasSrid) {
        unsigned char number[4];
        for (std::size_t i = 0; i < 4; ++i)
            number[i] = static_cast<unsigned char>(wkb[sridAt + (isLittle ? i : 3 - i)]);
        srid = number[0] | number[1] << 8 | number[2] << 16 | (number[3] & 0x7f) << 24;
        flags = static_cast<char>(flags & ~hasSrid);
        wkb.erase(sridAt, sridEnd - sridAt);
    }
    OGRGeometryH geometry = nullptr;
    if (OGR_G_CreateFromWkb(wkb.data(), nullptr, &geometry, static_cast<int>(wkb.size())) != OGRERR_NONE)
        return nullptr;
    return geometry;
}

OGRGeometryH parseText(const std::string& text, std::int32_t& srid) {
    if (text[0] == '{') {
        CPLJSONDocument document;
        if (!document.LoadMemory(text))
            return nullptr;
        const CPLJSONObject root = document.GetRoot(), part = root.GetObj("geometry");
        return OGR_G_CreateGeometryFromJson(
            (part.IsValid() ? part : root).Format(CPLJSONObject::PrettyFormat::Plain).c_str());
    }
    if (text.find('(') == text.npos)
        return parseWkb(text, srid);
    std::string copy = text;
    char* rest = copy.data();
    OGRGeometryH geometry = nullptr;
    if (OGR_G_CreateFromWkt(&rest, nullptr, &geometry) != OGRERR_NONE)
        return nullptr;
    return geometry;
}

} // namespace

Result<VectorPlace> placeOfGeometry(void* geometry, const CrsTransform& transform, bool isYFirst) {
    if (geometry && isYFirst)
        OGR_G_SwapXY(geometry);
    return placeOf(geometry, transform);
}

GeometryBatch placesOfTexts(const std::vector<std::string>& texts, const CrsTransform& transform,
                            bool isYFirst) {
    GeometryBatch batch;
    for (const std::string& text : texts) {
        const GdalErrors errors;
        batch.srids.push_back(0);
        const Geometry geometry(text.empty() ? nullptr : parseText(text, batch.srids.back()),
                                &OGR_G_DestroyGeometry);
        const Result<VectorPlace> place =
            geometry ? placeOfGeometry(geometry.get(), transform, isYFirst)
                     : problem(expectedFound("a geometry as WKT, EWKT, EWKB or GeoJSON", text) +
                               (errors.text().empty() ? "" : " (" + errors.text() + ')'));
        if (!place)
            batch.problems.push_back({batch.places.size(), place.problems().front().message});
        batch.places.push_back(place ? place.value() : VectorPlace());
    }
    return batch;
}

} // namespace osgTreeWind
