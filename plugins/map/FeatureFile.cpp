// SPDX-License-Identifier: MIT
#include <plugins/map/FeatureFile.h>

#include <plugins/map/CityJson.h>
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>
#include <plugins/map/GeometryPlace.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/system/Path.h>

#include <cpl_vsi.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// The supported formats: those of files on a disk, except CSV, which the library reads.
const char* const formats[] = {"GeoJSON",        "GeoJSONSeq", "TopoJSON", "ESRIJSON", "GPKG", "SQLite",
                               "FlatGeobuf",     "GML",        "LIBKML",   "KML",      "GPX",  "MapInfo File",
                               "ESRI Shapefile", "OSM",        "XLSX",     "ODS",      nullptr};

/// Whether a supported format has an extension such as ".shp". Excludes ".tab", which tables use, too.
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

/// GDAL's open options for a format.
const char* const* openOptions(const std::string& format) {
    static const char* const none[] = {nullptr};
    static const char* const gml[] = {"WRITE_GFS=NO", nullptr}; // do not write beside the user's files
    static const char* const osm[] = {"CONFIG_FILE=/vsimem/osmTags.ini", nullptr};
    // Tags of nodes to read as columns, in the format of GDAL's osmconf.ini.
    static std::string tags = "[points]\n"
                              "osm_id=yes\n"
                              "attributes=natural,species,taxon,genus,height,circumference,diameter,"
                              "diameter_crown,ref,name,denotation,leaf_type,leaf_cycle,start_date\n";
    if (format == "OSM")
        VSIFCloseL(VSIFileFromMemBuffer("/vsimem/osmTags.ini", reinterpret_cast<GByte*>(tags.data()),
                                        tags.size(), FALSE));
    return format == "OSM" ? osm : format == "GML" ? gml : none;
}

/// The layer of OpenStreetMap files with the trees.
const std::string nodes = "points";

std::string layerName(OGRLayerH layer) {
    return OGR_L_GetName(layer);
}

} // namespace

int FeatureFile::layerCount() const {
    return GDALDatasetGetLayerCount(_data.get());
}

OGRLayerH FeatureFile::layerAt(int index) const {
    return GDALDatasetGetLayer(_data.get(), index);
}

/// 'layer "trees"' for messages; empty if the file has only one layer.
std::string FeatureFile::where() const {
    return _layer && layerCount() > 1 ? "layer " + inQuotes(layerName(_layer)) : std::string();
}

std::string FeatureFile::withLayer(const std::string& message) const {
    const std::string place = where();
    return place.empty() ? message : place + ": " + message;
}

bool FeatureFile::isSupported(const std::string& path) {
    registerGdal();
    const GdalErrors ignored;
    return isOfFormat(lower(extensionOf(path))) ||
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
        return fileProblem(path, "cannot be read: " + errors.textOr("GDAL does not support its format"));
    file._head.warnings = errors.warnings();
    for (int i = 0; i < file.layerCount(); ++i)
        file._head.layers.push_back(layerName(file.layerAt(i)));
    return file;
}

Result<FeatureLayer> FeatureFile::chooseLayer(const std::string& layer) {
    const GdalErrors errors;
    const std::vector<std::string>& names = _head.layers;
    const bool isOsm = _head.format == "OSM";
    const std::string& wanted = layer.empty() && isOsm ? nodes : layer;
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (names.empty())
        return fileProblem(_path, "expected a layer, found none");
    const std::string known = std::to_string(names.size()) + " layers, of which " + inQuotes(names.front()) +
                              " is the first; ogrinfo lists them";
    if (wanted.empty() && names.size() > 1)
        return fileProblem(_path, "expected layer to name one of its " + known);
    if (!wanted.empty() && found == names.end())
        return fileProblem(_path, "no layer " + inQuotes(wanted) +
                                      (names.size() > 1 ? " among its " + known
                                                        : "; its only layer is " + inQuotes(names.front())));
    _layer = layerAt(wanted.empty() ? 0 : static_cast<int>(found - names.begin()));
    if (isOsm) // saves time for the other layers
        GDALDatasetExecuteSQL(_data.get(), ("SET interest_layers = " + wanted).c_str(), nullptr, nullptr);
    FeatureLayer chosen;
    chosen.messagePrefix = where();
    const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(_layer);
    for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i)
        chosen.columns.emplace_back(OGR_Fld_GetNameRef(OGR_FD_GetFieldDefn(definition, i)));
    if (const OGRSpatialReferenceH reference = OGR_L_GetSpatialRef(_layer);
        reference && !OSRIsLocal(reference))
        chosen.crs = GdalCrs(OSRClone(reference)).crs().facts();
    chosen.hasGeometry = OGR_L_GetGeomType(_layer) != wkbNone;
    return chosen;
}

Result<MapAcknowledgement> FeatureFile::rewind(CrsTransform transform, std::vector<std::size_t> columns,
                                               bool isYFirst) {
    const GdalErrors ignored;
    OGR_L_ResetReading(_layer);
    _transform = std::move(transform);
    _isYFirst = isYFirst;
    _columns = std::move(columns);
    const int count = OGR_FD_GetFieldCount(OGR_L_GetLayerDefn(_layer));
    if (_columns.empty())
        for (int i = 0; i < count; ++i)
            _columns.push_back(static_cast<std::size_t>(i));
    return MapAcknowledgement();
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
            batch.problem = withLayer("reading failed: " + errors.text());
        batch.isLast = !feature || !batch.problem.empty();
        if (batch.isLast)
            break;
        add(feature.get(), batch);
    }
    return batch;
}

void FeatureFile::add(OGRFeatureH feature, FeatureBatch& batch) const {
    batch.ids.push_back(OGR_F_GetFID(feature));
    const Result<VectorPlace> place = placeOfGeometry(OGR_F_GetGeometryRef(feature), _transform, _isYFirst);
    if (!place)
        batch.placeProblems.push_back({batch.ids.size() - 1, place.problems().front().message});
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
