// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfCrs.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <ogr_spatialref.h>

#include <cmath>

namespace osgTreeWind {

namespace {

bool runsAlong(const NetCdfArray& array, const std::string& dimension) {
    for (const NetCdfDimension& one : array.dimensions)
        if (one.name == dimension)
            return true;
    return false;
}

/// An array of longitudes or latitudes over this and another dimension; null if there is none.
NetCdfFile::Array curvilinear(const NetCdfFile& file, const std::string& dimension) {
    return file.find([&](const NetCdfArray& array) {
        const NetCdfMeasure measure = measureOf(array);
        return array.dimensions.size() >= 2 && runsAlong(array, dimension) &&
               (measure == NetCdfMeasure::Longitude || measure == NetCdfMeasure::Latitude);
    });
}

/// Offset from coordinates of an axis to those in the CRS, from a second coordinate array such as PALM's
/// E_UTM(x). Empty if that array shows that the grid is rotated.
std::optional<double> crsOffset(NetCdfFile& file, const NetCdfDimension& dimension, const char* standardName,
                                const NetCdfAxis& axis) {
    const NetCdfFile::Array own = file.array(dimension.coordinates);
    if (!own || own->text("standard_name") == standardName)
        return 0.0;
    bool isTurned = false;
    for (const NetCdfFile::Array& array : file.arrays()) {
        if (array->text("standard_name") != standardName || !runsAlong(*array, dimension.name))
            continue;
        if (array->dimensions.size() > 1) {
            isTurned = true;
            continue;
        }
        const std::vector<double> at = file.coordinates(*array);
        return at.empty() ? 0.0 : at.front() - axis.points.first;
    }
    return isTurned ? std::nullopt : std::optional<double>(0.0);
}

/// CRS of a grid mapping with a rotated pole, which GDAL does not support.
std::optional<Crs> rotatedOf(const NetCdfFile& file, const NetCdfArray& wind) {
    const NetCdfFile::Array mapping = file.array(wind.text("grid_mapping"));
    if (!mapping || mapping->text("grid_mapping_name") != "rotated_latitude_longitude")
        return std::nullopt;
    const auto latitude = mapping->number("grid_north_pole_latitude"),
               longitude = mapping->number("grid_north_pole_longitude");
    if (!latitude || !longitude || !(std::abs(*latitude) <= 90.0) || !(std::abs(*longitude) <= 360.0))
        return std::nullopt;
    const GdalErrors errors;
    auto reference = std::make_unique<OGRSpatialReference>();
    reference->importFromEPSG(4326);
    if (reference->SetDerivedGeogCRSWithPoleRotationNetCDFCFConvention(
            "Rotated pole", *latitude, *longitude,
            mapping->number("north_pole_grid_longitude").value_or(0.0)) != OGRERR_NONE)
        return std::nullopt;
    reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return GdalCrs(OGRSpatialReference::ToHandle(reference.release())).crs();
}

std::optional<Crs> degreesOf(NetCdfFile& file, const NetCdfArray& wind, const NetCdfDimension& x) {
    const NetCdfFile::Array coordinates = file.array(x.coordinates);
    const bool rotated = coordinates && coordinates->text("standard_name") == "grid_longitude";
    std::optional<Crs> stated = rotatedOf(file, wind);
    if (!stated && !wind.text("grid_mapping").empty())
        stated = wind.crs();
    if (stated && !stated->isDegrees())
        stated.reset();
    if (rotated && (!stated || !isRotated(*stated)))
        file.fail(wind.name, "expected a grid_mapping of a rotated pole, as its dimension " + x.name +
                                 " counts longitudes of one, found " +
                                 expectedFound("", wind.text("grid_mapping")).substr(17));
    return stated ? stated : Crs::wgs84();
}

} // namespace

std::optional<Crs> readCrs(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points,
                           WindSummary& summary) {
    const NetCdfRoles roles = rolesOf(file, wind);
    if (!roles.x || !roles.y || wind.dimensions.size() < 2) {
        file.fail(wind.name, "expected dimensions (time, height, y, x) or fewer");
        return std::nullopt;
    }
    const NetCdfDimension &x = wind.dimensions[*roles.x], &y = wind.dimensions[*roles.y];
    for (const NetCdfDimension* dimension : {&x, &y})
        if (const auto both =
                file.array(dimension->coordinates) ? nullptr : curvilinear(file, dimension->name))
            file.fail(both->name,
                      "expected longitudes and latitudes of one dimension each, or x and y of a projection; "
                      "found them on " +
                          std::to_string(both->dimensions.size()) + " (a curvilinear grid)");
    points.xAxis = axisOf(file, x);
    points.yAxis = axisOf(file, y);
    if (!file.good())
        return std::nullopt;
    if (points.xAxis.isDegrees() != points.yAxis.isDegrees()) {
        file.fail(wind.name, "expected both of its dimensions " + y.name + " and " + x.name +
                                 " in degrees or both in a map projection");
        return std::nullopt;
    }
    std::optional<Crs> crs;
    if (points.xAxis.isDegrees())
        crs = degreesOf(file, wind, x);
    else if (crs = wind.crs(); crs && crs->isDegrees())
        crs.reset();
    else if (crs) {
        const auto east = crsOffset(file, x, "projection_x_coordinate", points.xAxis),
                   north = crsOffset(file, y, "projection_y_coordinate", points.yAxis);
        if (east && north)
            points.mapOffset = {*east, *north};
        else {
            summary.notes.push_back("the grid is rotated relative to its projection, " + nameOf(*crs) +
                                    "; x and y are metres from its corner");
            crs.reset();
        }
    }
    if (!crs)
        return crs;
    summary.crs = crs->text();
    summary.coordinates = nameOf(*crs);
    return crs;
}

std::string nameOf(const Crs& crs) {
    const Result<GdalCrs> reference = GdalCrs::parse(crs.text());
    const std::string name = reference ? orEmpty(OSRGetName(reference.value().reference())) : "";
    for (const char* none : {"", "unnamed", "unknown", "undefined"})
        if (name == none)
            return projText(crs);
    return name;
}

bool isRotated(const Crs& crs) {
    const Result<GdalCrs> reference = GdalCrs::parse(crs.text());
    return reference && OSRIsDerivedGeographic(reference.value().reference()) != 0;
}

} // namespace osgTreeWind
