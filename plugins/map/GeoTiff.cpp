// SPDX-License-Identifier: MIT
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalRaster.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/MapCells.h>

#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <filesystem>
#include <memory>

namespace osgTreeWind {

namespace {

/// The unit that a band has, or that the metadata of it or of its file name.
std::string unitOf(GDALDatasetH data, GDALRasterBandH band) {
    if (std::string unit = GDALGetRasterUnitType(band); !unit.empty())
        return unit;
    for (const GDALMajorObjectH owner : {band, data})
        for (char** item = GDALGetMetadata(owner, nullptr); item && *item; ++item) {
            char* name = nullptr;
            std::string value = CPLParseNameValue(*item, &name);
            const bool isUnit = name && lower(name).find("unit") != std::string::npos;
            CPLFree(name);
            if (isUnit)
                return value;
        }
    return {};
}

/// What of the file is not as expected; empty: nothing.
std::string problemOf(const std::string& path, GDALDatasetH data, const double (&toPlace)[6]) {
    constexpr int most = 100000;
    if (GDALGetRasterCount(data) != 1)
        return "expected one band, found " + std::to_string(GDALGetRasterCount(data));
    if (GDALGetRasterXSize(data) > most || GDALGetRasterYSize(data) > most)
        return "expected at most 100000 cells each way";
    constexpr double bestRatio = 1100.0; // deflate cannot do better than 1032 to 1
    const double count = static_cast<double>(GDALGetRasterXSize(data)) * GDALGetRasterYSize(data);
    std::error_code ignored;
    if (count > bestRatio * static_cast<double>(std::filesystem::file_size(path, ignored)))
        return "the file is too short for " + numberText(count) + " cells";
    if (toPlace[2] != 0.0 || toPlace[4] != 0.0 || !(toPlace[1] > 0.0) || !(toPlace[5] < 0.0))
        return "expected rows from the north southward, not turned";
    if (std::abs(toPlace[1] + toPlace[5]) * GDALGetRasterYSize(data) > 1e-3 * toPlace[1])
        return "expected square cells, found " + numberText(toPlace[1]) + " x " + numberText(-toPlace[5]);
    return {};
}

/// Row by row from the south; false where they cannot be read.
bool readCells(GDALRasterBandH band, MapCells& cells) {
    const int columns = cells.cells.x, rows = cells.cells.y;
    cells.values.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    bool isRead = true;
    for (int row = 0; row < rows && isRead; ++row)
        isRead = readRows(
            band, row, 1, columns,
            &cells.values[static_cast<std::size_t>(rows - 1 - row) * static_cast<std::size_t>(columns)]);
    return isRead;
}

} // namespace

Result<MapCells> readGeoTiffCells(const std::string& path) {
    registerGdal();
    const GdalErrors errors;
    const char* const drivers[] = {"GTiff", nullptr};
    const std::unique_ptr<void, decltype(&GDALClose)> data(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers, nullptr,
                   nullptr),
        &GDALClose);
    if (!data)
        return fileProblem(path, "cannot be read: " + errors.textOr("no GeoTIFF"));
    double toPlace[6];
    if (GDALGetGeoTransform(data.get(), toPlace) != CE_None)
        return fileProblem(path, "it does not say where it lies: expected a geotransform");
    if (const std::string problem = problemOf(path, data.get(), toPlace); !problem.empty())
        return fileProblem(path, problem);
    const GDALRasterBandH band = GDALGetRasterBand(data.get(), 1);
    MapCells cells;
    cells.cells = {GDALGetRasterXSize(data.get()), GDALGetRasterYSize(data.get())};
    cells.cellSize = toPlace[1];
    cells.south = {toPlace[0] + 0.5 * toPlace[1], toPlace[3] + (cells.cells.y - 0.5) * toPlace[5]};
    if (const OGRSpatialReferenceH reference = GDALGetSpatialRef(data.get());
        reference && !OSRIsLocal(reference))
        cells.crs = GdalCrs(OSRClone(reference)).crs().text();
    cells.unit = unitOf(data.get(), band);
    if (!readCells(band, cells) || !errors.text().empty())
        return fileProblem(path, "cannot be read on: " + errors.textOr("it ends early"));
    return cells;
}

} // namespace osgTreeWind
