// SPDX-License-Identifier: MIT
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalRaster.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/RasterBand.h>
#include <osgTreeWind/system/Path.h>

#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <filesystem>
#include <memory>

namespace osgTreeWind {

namespace {

/// The unit of a band, or the unit in the metadata of the band or the file.
std::string unitOf(GDALDatasetH data, GDALRasterBandH band) {
    if (std::string unit = GDALGetRasterUnitType(band); !unit.empty())
        return unit;
    for (const GDALMajorObjectH owner : {band, data})
        for (auto item = GDALGetMetadata(owner, nullptr); item && *item; ++item) {
            char* name = nullptr;
            std::string value = CPLParseNameValue(*item, &name);
            const bool isUnit = name && lower(name).find("unit") != std::string::npos;
            CPLFree(name);
            if (isUnit)
                return value;
        }
    return {};
}

/// Why a file is not supported; empty if it is.
std::string problemOf(const std::string& path, GDALDatasetH data, const double (&geotransform)[6]) {
    constexpr int most = 100000;
    if (GDALGetRasterCount(data) != 1)
        return "expected one band, found " + std::to_string(GDALGetRasterCount(data));
    if (GDALGetRasterXSize(data) > most || GDALGetRasterYSize(data) > most)
        return "expected at most 100000 cells each way";
    constexpr double bestRatio = 1100.0; // deflate reaches at most 1032 to 1
    const double count = static_cast<double>(GDALGetRasterXSize(data)) * GDALGetRasterYSize(data);
    std::error_code ignored;
    if (count > bestRatio * static_cast<double>(std::filesystem::file_size(toPath(path), ignored)))
        return "the file is too short for " + numberText(count) + " cells";
    if (geotransform[2] != 0.0 || geotransform[4] != 0.0 || !(geotransform[1] > 0.0) ||
        !(geotransform[5] < 0.0))
        return "expected rows from the north southward, not turned";
    if (std::abs(geotransform[1] + geotransform[5]) * GDALGetRasterYSize(data) > 1e-3 * geotransform[1])
        return "expected square cells, found " + numberText(geotransform[1]) + " x " +
               numberText(-geotransform[5]);
    return {};
}

/// Reads the rows from south to north. @return false if reading failed.
bool readCells(GDALRasterBandH band, RasterBand& cells) {
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

Result<RasterBand> readGeoTiffBand(const std::string& path) {
    registerGdal();
    const GdalErrors errors;
    const char* const drivers[] = {"GTiff", nullptr};
    const std::unique_ptr<void, decltype(&GDALClose)> data(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers, nullptr,
                   nullptr),
        &GDALClose);
    if (!data)
        return fileProblem(path, "cannot be read: " + errors.textOr("not a GeoTIFF"));
    double geotransform[6];
    if (GDALGetGeoTransform(data.get(), geotransform) != CE_None)
        return fileProblem(path, "expected a geotransform, found none");
    if (const std::string problem = problemOf(path, data.get(), geotransform); !problem.empty())
        return fileProblem(path, problem);
    const GDALRasterBandH band = GDALGetRasterBand(data.get(), 1);
    RasterBand cells;
    cells.cells = {GDALGetRasterXSize(data.get()), GDALGetRasterYSize(data.get())};
    cells.cellSize = geotransform[1];
    cells.southWest = {geotransform[0] + 0.5 * geotransform[1],
                       geotransform[3] + (cells.cells.y - 0.5) * geotransform[5]};
    if (const OGRSpatialReferenceH reference = GDALGetSpatialRef(data.get());
        reference && !OSRIsLocal(reference))
        cells.crs = GdalCrs(OSRClone(reference)).crs().text();
    cells.unit = unitOf(data.get(), band);
    if (!readCells(band, cells) || !errors.text().empty())
        return fileProblem(path, "reading failed: " + errors.textOr("the file is truncated"));
    return cells;
}

} // namespace osgTreeWind
