// SPDX-License-Identifier: MIT
#include <plugins/map/FeatureFile.h>

#include <plugins/map/CityJson.h>
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Formats of files that stand on a disk by themselves. CSV has a reader of its own.
const char* const formats[] = {"GeoJSON",        "GeoJSONSeq", "TopoJSON", "ESRIJSON", "GPKG", "SQLite",
                               "FlatGeobuf",     "GML",        "LIBKML",   "KML",      "GPX",  "MapInfo File",
                               "ESRI Shapefile", "OSM",        "XLSX",     "ODS",      nullptr};

/// Whether files of a format are called so (".shp"). Tables parted by tabs are called ".tab", too.
bool isOfFormat(const std::string& extension) {
    if (extension.size() < 2 || extension == ".tab")
        return false;
    for (const char* const* format = formats; *format; ++format) {
        const GDALDriverH driver = GDALGetDriverByName(*format);
        const char* known = driver ? GDALGetMetadataItem(driver, GDAL_DMD_EXTENSIONS, nullptr) : nullptr;
        if (known &&
            (' ' + std::string(known) + ' ').find(' ' + extension.substr(1) + ' ') != std::string::npos)
            return true;
    }
    return false;
}

/// What GDAL is to be told about a file of a format as it opens it.
const char* const* openOptions(const std::string& format) {
    static const char* const none[] = {nullptr};
    static const char* const gml[] = {"WRITE_GFS=NO", nullptr}; // nothing beside other people's files
    static const char* const osm[] = {"CONFIG_FILE=/vsimem/osmTags.ini", nullptr};
    // The tags of nodes that are columns, in the form of GDAL's osmconf.ini.
    static std::string tags = "[points]\n"
                              "osm_id=yes\n"
                              "attributes=natural,species,taxon,genus,height,circumference,diameter,"
                              "diameter_crown,ref,name,denotation,leaf_type,leaf_cycle,start_date\n";
    if (format == "OSM")
        VSIFCloseL(VSIFileFromMemBuffer("/vsimem/osmTags.ini", reinterpret_cast<GByte*>(tags.data()),
                                        tags.size(), FALSE));
    return format == "OSM" ? osm : format == "GML" ? gml : none;
}

/// The layer of an OpenStreetMap file in which trees are.
const std::string nodes = "points";

std::string nameOf(OGRLayerH layer) {
    return OGR_L_GetName(layer);
}

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

/// Where an OGRGeometryH is, if it is a point or an outline; null is an error, too.
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

} // namespace

int FeatureFile::count() const {
    return GDALDatasetGetLayerCount(_data.get());
}

OGRLayerH FeatureFile::at(int index) const {
    return GDALDatasetGetLayer(_data.get(), index);
}

/// "layer "trees"", where there is something to tell apart.
std::string FeatureFile::where() const {
    return _layer && count() > 1 ? "layer " + inQuotes(nameOf(_layer)) : std::string();
}

std::string FeatureFile::described(const std::string& message) const {
    const std::string place = where();
    return place.empty() ? message : place + ": " + message;
}

bool FeatureFile::knows(const std::string& path) {
    registerGdal();
    const GdalErrors unheard;
    return isOfFormat(lower(std::filesystem::path(path).extension().string())) ||
           GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, formats, nullptr) || isCityJson(path);
}

Result<FeatureFile> FeatureFile::open(const std::string& path) {
    registerGdal();
    const GdalErrors errors;
    FeatureFile file;
    file._path = path;
    if (isCityJson(path)) {
        auto city = readCityJson(path);
        if (!city)
            return city.problems();
        file._data = city.value();
        file._head.format = "CityJSON";
    } else {
        const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, formats, nullptr);
        file._head.format = driver ? GDALGetDriverShortName(driver) : "";
        if (void* data = GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                    formats, openOptions(file._head.format), nullptr))
            file._data.reset(data, [](void* opened) { GDALClose(opened); });
    }
    if (!file._data || !errors.text().empty())
        return fileProblem(path, "cannot be read: " + errors.textOr("GDAL knows no such format"));
    file._head.warnings = errors.warnings();
    for (int i = 0; i < file.count(); ++i)
        file._head.layers.push_back(nameOf(file.at(i)));
    return file;
}

Result<FeatureLayer> FeatureFile::chooseLayer(const std::string& layer) {
    const GdalErrors errors;
    const std::vector<std::string>& names = _head.layers;
    const bool isOsm = _head.format == "OSM";
    const std::string& wanted = layer.empty() && isOsm ? nodes : layer;
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (names.empty())
        return fileProblem(_path, "no layers in it");
    const std::string known = std::to_string(names.size()) + " layers, of which " + inQuotes(names.front()) +
                              " is the first; ogrinfo lists them";
    if (wanted.empty() && names.size() > 1)
        return fileProblem(_path, "expected layer to name one of its " + known);
    if (!wanted.empty() && found == names.end())
        return fileProblem(_path, "no layer " + inQuotes(wanted) +
                                      (names.size() > 1 ? " among its " + known
                                                        : "; its only layer is " + inQuotes(names.front())));
    _layer = at(wanted.empty() ? 0 : static_cast<int>(found - names.begin()));
    if (isOsm) // the others need not be put together
        GDALDatasetExecuteSQL(_data.get(), ("SET interest_layers = " + wanted).c_str(), nullptr, nullptr);
    FeatureLayer chosen;
    chosen.where = where();
    const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(_layer);
    for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i)
        chosen.columns.emplace_back(OGR_Fld_GetNameRef(OGR_FD_GetFieldDefn(definition, i)));
    if (const OGRSpatialReferenceH reference = OGR_L_GetSpatialRef(_layer);
        reference && !OSRIsLocal(reference))
        chosen.crs = GdalCrs(OSRClone(reference)).crs().facts();
    chosen.hasGeometry = OGR_L_GetGeomType(_layer) != wkbNone;
    return chosen;
}

Result<MapDone> FeatureFile::rewind(CrsWay way, std::vector<std::size_t> columns) {
    const GdalErrors unheard;
    OGR_L_ResetReading(_layer);
    _way = std::move(way);
    _columns = std::move(columns);
    const int count = OGR_FD_GetFieldCount(OGR_L_GetLayerDefn(_layer));
    if (_columns.empty())
        for (int i = 0; i < count; ++i)
            _columns.push_back(static_cast<std::size_t>(i));
    return MapDone();
}

FeatureBatch FeatureFile::next() {
    constexpr std::size_t most = 4096;
    const GdalErrors errors;
    FeatureBatch batch;
    batch.columns.resize(_columns.size());
    while (batch.ids.size() < most) {
        const std::unique_ptr<void, decltype(&OGR_F_Destroy)> feature(OGR_L_GetNextFeature(_layer),
                                                                      &OGR_F_Destroy);
        if (!errors.text().empty())
            batch.problem = described("cannot be read on: " + errors.text());
        batch.isLast = !feature || !batch.problem.empty();
        if (batch.isLast)
            break;
        add(feature.get(), batch);
    }
    return batch;
}

void FeatureFile::add(OGRFeatureH feature, FeatureBatch& batch) const {
    batch.ids.push_back(OGR_F_GetFID(feature));
    const Result<VectorPlace> place = placeOf(OGR_F_GetGeometryRef(feature), _way);
    if (!place)
        batch.placeless.push_back({batch.ids.size() - 1, place.problems().front().message});
    batch.places.push_back(place ? place.value() : VectorPlace());
    for (std::size_t i = 0; i < _columns.size(); ++i) {
        const int index = static_cast<int>(_columns[i]);
        FeatureBatch::Column& column = batch.columns[i];
        unsigned char kind = FeatureBatch::Missing;
        double number = 0.0;
        if (OGR_F_IsFieldSetAndNotNull(feature, index)) {
            const OGRFieldType type = OGR_Fld_GetType(OGR_F_GetFieldDefnRef(feature, index));
            const bool isNumber = type == OFTReal || type == OFTInteger || type == OFTInteger64;
            kind = isNumber ? FeatureBatch::Number : FeatureBatch::Text;
            number = isNumber ? OGR_F_GetFieldAsDouble(feature, index) : 0.0;
            column.texts += OGR_F_GetFieldAsString(feature, index);
        }
        column.kinds.push_back(kind);
        column.numbers.push_back(number);
        column.ends.push_back(static_cast<std::uint32_t>(column.texts.size()));
    }
}

} // namespace osgTreeWind
