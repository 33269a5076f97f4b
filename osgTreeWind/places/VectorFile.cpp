// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/VectorFile.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/CityJson.h>
#include <osgTreeWind/places/FeatureShape.h>
#include <osgTreeWind/places/GdalErrors.h>
#include <osgTreeWind/places/OpenOptions.h>

#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <algorithm>
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

/// The layer of an OpenStreetMap file in which trees are.
const std::string nodes = "points";

std::string nameOf(OGRLayerH layer) {
    return OGR_L_GetName(layer);
}

} // namespace

struct VectorFile::Reading {
    std::string path;
    std::string format;         ///< GDAL's name of it.
    std::shared_ptr<void> data; ///< GDALDatasetH.
    OGRLayerH layer = nullptr;  ///< Of `data`.
    std::unique_ptr<void, decltype(&OGR_F_Destroy)> feature{nullptr, &OGR_F_Destroy};
    std::vector<std::string> columns, warnings;
    std::optional<Crs> crs;

    int count() const { return GDALDatasetGetLayerCount(data.get()); }
    OGRLayerH at(int index) const { return GDALDatasetGetLayer(data.get(), index); }
    /// "layer "trees"", where there is something to tell apart.
    std::string where() const { return count() > 1 ? "layer " + inQuotes(nameOf(layer)) : std::string(); }
    Diagnostic problem(const std::string& message) const {
        const std::string place = layer ? where() : std::string();
        return fileProblem(path, place.empty() ? message : place + ": " + message);
    }

    void choose(OGRLayerH chosen);
};

void VectorFile::Reading::choose(OGRLayerH chosen) {
    layer = chosen;
    columns.clear();
    crs.reset();
    const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(layer);
    for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i)
        columns.emplace_back(OGR_Fld_GetNameRef(OGR_FD_GetFieldDefn(definition, i)));
    if (const OGRSpatialReferenceH reference = OGR_L_GetSpatialRef(layer);
        reference && !OSRIsLocal(reference))
        crs = Crs(OSRClone(reference));
}

VectorFile::VectorFile() = default;
VectorFile::VectorFile(std::unique_ptr<Reading> reading) : _reading(std::move(reading)) {}
VectorFile::VectorFile(VectorFile&&) noexcept = default;
VectorFile& VectorFile::operator=(VectorFile&&) noexcept = default;
VectorFile::~VectorFile() {
    const GdalErrors unheard;
    _reading.reset();
}

bool VectorFile::knows(const std::string& path) {
    const std::string extension = lower(std::filesystem::path(path).extension().string());
    if (extension == ".csv")
        return false;
    registerGdal();
    const GdalErrors unheard;
    return isOfFormat(extension) || GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, formats, nullptr) ||
           isCityJson(path);
}

Result<VectorFile> VectorFile::open(const std::string& path) {
    registerGdal();
    const GdalErrors errors;
    auto reading = std::make_unique<Reading>();
    reading->path = path;
    if (isCityJson(path)) {
        auto city = readCityJson(path);
        if (!city)
            return city.problems();
        reading->data = city.value();
        reading->format = "CityJSON";
    } else {
        const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, formats, nullptr);
        reading->format = driver ? GDALGetDriverShortName(driver) : "";
        const OpenOptions options(reading->format);
        if (void* data = GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                    formats, options.list(), nullptr))
            reading->data.reset(data, [](void* opened) { GDALClose(opened); });
    }
    if (!reading->data || !errors.text().empty())
        return fileProblem(path, "cannot be read: " + errors.textOr("GDAL knows no such format"));
    reading->warnings = errors.warnings();
    return VectorFile(std::move(reading));
}

const std::string& VectorFile::path() const {
    return _reading->path;
}

const std::string& VectorFile::format() const {
    return _reading->format;
}

std::vector<std::string> VectorFile::layers() const {
    std::vector<std::string> names;
    for (int i = 0; i < _reading->count(); ++i)
        names.push_back(nameOf(_reading->at(i)));
    return names;
}

Diagnostics VectorFile::chooseLayer(const std::string& layer) {
    const GdalErrors errors;
    const std::vector<std::string> names = layers();
    const bool isOsm = _reading->format == "OSM";
    const std::string& wanted = layer.empty() && isOsm ? nodes : layer;
    const auto found = std::find(names.begin(), names.end(), wanted);
    const auto problem = [&](const std::string& message) {
        return Diagnostics{fileProblem(_reading->path, message + joined(names))};
    };
    if (names.empty())
        return problem("no layers in it");
    if (wanted.empty() && names.size() > 1)
        return problem("expected layer to name one of its layers: ");
    if (!wanted.empty() && found == names.end())
        return problem("no layer " + inQuotes(wanted) + "; it has: ");
    _reading->choose(_reading->at(wanted.empty() ? 0 : static_cast<int>(found - names.begin())));
    if (isOsm) // the others need not be put together
        GDALDatasetExecuteSQL(_reading->data.get(), ("SET interest_layers = " + wanted).c_str(), nullptr,
                              nullptr);
    return {};
}

Diagnostics VectorFile::filter(const std::string& condition) {
    const GdalErrors errors;
    if (OGR_L_SetAttributeFilter(_reading->layer, condition.c_str()) != OGRERR_NONE || !errors.text().empty())
        return {_reading->problem("the filter cannot be used: " + errors.textOr("not SQL"))};
    return {};
}

const std::vector<std::string>& VectorFile::columns() const {
    return _reading->columns;
}

const std::optional<Crs>& VectorFile::crs() const {
    return _reading->crs;
}

bool VectorFile::hasGeometry() const {
    return OGR_L_GetGeomType(_reading->layer) != wkbNone;
}

const std::vector<std::string>& VectorFile::warnings() const {
    return _reading->warnings;
}

void VectorFile::rewind() {
    const GdalErrors unheard;
    OGR_L_ResetReading(_reading->layer);
}

Result<bool> VectorFile::next() {
    const GdalErrors errors;
    _reading->feature.reset(); // first: a layer may lend the same memory again
    _reading->feature.reset(OGR_L_GetNextFeature(_reading->layer));
    if (!errors.text().empty())
        return _reading->problem("cannot be read on: " + errors.text());
    return static_cast<bool>(_reading->feature);
}

std::string VectorFile::feature() const {
    const std::string layer = _reading->where();
    return layer + (layer.empty() ? "" : ", ") + "feature " +
           std::to_string(OGR_F_GetFID(_reading->feature.get()));
}

bool VectorFile::has(std::size_t column) const {
    return OGR_F_IsFieldSetAndNotNull(_reading->feature.get(), static_cast<int>(column));
}

std::string VectorFile::text(std::size_t column) const {
    return has(column) ? OGR_F_GetFieldAsString(_reading->feature.get(), static_cast<int>(column)) : "";
}

std::optional<double> VectorFile::number(std::size_t column) const {
    const OGRFeatureH feature = _reading->feature.get();
    const int index = static_cast<int>(column);
    const OGRFieldType type = OGR_Fld_GetType(OGR_F_GetFieldDefnRef(feature, index));
    if (!has(column) || (type != OFTReal && type != OFTInteger && type != OFTInteger64))
        return std::nullopt;
    return OGR_F_GetFieldAsDouble(feature, index);
}

Result<VectorPlace> VectorFile::place(const CrsWay& way) const {
    return placeOf(OGR_F_GetGeometryRef(_reading->feature.get()), way);
}

} // namespace osgTreeWind
