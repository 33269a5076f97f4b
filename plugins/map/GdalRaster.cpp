// SPDX-License-Identifier: MIT
#include <plugins/map/GdalRaster.h>

#include <plugins/map/RasterFormats.h>

#include <plugins/map/GdalCrs.h>
#include <plugins/map/Udunits.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double maxCells = 4e8;

constexpr Range heightRange = within(-12000, 30000); // metres: excludes common values for missing data

/// Metres per unit of the heights; empty for an unknown unit.
std::optional<double> metresPerUnit(GDALRasterBandH band, OGRSpatialReferenceH reference) {
    const std::string name = GDALGetRasterUnitType(band);
    if (name.empty())
        return reference && OSRIsCompound(reference)
                   ? OSRGetTargetLinearUnits(reference, "COMPD_CS|VERT_CS", nullptr)
                   : 1.0;
    if (const auto known = knownUnit(Dimension::Length, name))
        return known;
    const double size = sizeByUdunits(name, "m");
    return size > 0.0 ? std::optional(size) : std::nullopt;
}

bool isHeightName(const std::string& name) {
    for (const char* const part : {"elevation", "altitude", "height", "dem", "dtm", "dsm"})
        if (name.find(part) != std::string::npos)
            return true;
    return false;
}

} // namespace

GdalRaster::GdalRaster(const std::string& path, std::string band)
    : _path(path), _bandName(std::move(band)), _data(nullptr, [](void* opened) {
          if (opened)
              GDALClose(opened);
      }) {
    registerGdal();
    _formatProblem = problemOfRaster(path);
    if (!_formatProblem.empty())
        return;
    deregisterOtherRasterDrivers();
    _data.reset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                           rasterFormats().data(), nullptr, nullptr));
}

Diagnostic GdalRaster::problem(const std::string& message) const {
    return fileProblem(_path, message);
}

Result<RasterHeader> GdalRaster::head() {
    if (!_formatProblem.empty())
        return problem(_formatProblem);
    if (!_data || !_errors.text().empty())
        return problem("cannot be read: " + _errors.textOr("GDAL does not support its format"));
    RasterHeader head;
    head.columns = _columns = GDALGetRasterXSize(_data.get());
    head.rows = _rows = GDALGetRasterYSize(_data.get());
    if (const std::string bands = problemOfBands(); !bands.empty())
        return problem(bands);
    if (static_cast<double>(_columns) * _rows > maxCells)
        return problem("expected at most " + numberText(maxCells) + " cells, found " +
                       std::to_string(_columns) + " x " + std::to_string(_rows) +
                       "; gdal_translate -projwin cuts a part out");
    std::array<double, 6>& geotransform = head.geotransform;
    if (GDALGetGeoTransform(_data.get(), geotransform.data()) != CE_None)
        return problem("expected a geotransform, found none");
    if (!std::all_of(geotransform.begin(), geotransform.end(), [](double x) { return std::isfinite(x); }) ||
        !GDALInvGeoTransform(geotransform.data(), head.inverseGeotransform.data()))
        return problem("its cells have no extent");
    const OGRSpatialReferenceH reference = GDALGetSpatialRef(_data.get());
    const auto unit = metresPerUnit(_band, reference);
    if (!unit)
        return problem("expected heights in metres or feet, found the unit " +
                       inQuotes(GDALGetRasterUnitType(_band)));
    if (reference && !OSRIsLocal(reference))
        head.crs = GdalCrs(OSRClone(reference)).crs().facts();
    _scale = GDALGetRasterScale(_band, nullptr) * *unit;
    _offset = GDALGetRasterOffset(_band, nullptr) * *unit;
    return head;
}

/// The band of the key ground.band. Without that key, the only band, or the only one with a name for heights.
/// Null if there is no such band.
void* GdalRaster::chooseBand(const std::vector<void*>& bands) const {
    std::vector<void*> called;
    for (void* const band : bands) {
        const std::string name = GDALGetDescription(band), small = lower(name);
        if (_bandName.empty() ? isHeightName(small)
                              : name == _bandName || std::to_string(GDALGetBandNumber(band)) == _bandName)
            called.push_back(band);
    }
    if (_bandName.empty() && bands.size() == 1)
        return bands.front();
    return called.size() == 1 ? called.front() : nullptr;
}

std::string GdalRaster::problemOfBands() {
    std::vector<GDALRasterBandH> bands;
    for (int i = 1; i <= GDALGetRasterCount(_data.get()); ++i)
        if (const GDALRasterBandH band = GDALGetRasterBand(_data.get(), i);
            GDALGetRasterColorInterpretation(band) != GCI_AlphaBand || _bandName == std::to_string(i))
            bands.push_back(band);
    _band = chooseBand(bands);
    if (!_band && !_bandName.empty())
        return "no band " + inQuotes(_bandName) + " among its " + std::to_string(bands.size()) +
               "; gdalinfo lists them";
    if (!_band)
        return "expected one band of heights, found " + std::to_string(bands.size()) +
               "; select one by ground.band, its number or name (gdalinfo)";
    if (GDALGetRasterColorInterpretation(_band) == GCI_PaletteIndex)
        return "expected heights, found colours of a palette";
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(_band)))
        return "expected heights, found complex numbers";
    return {};
}

/// Reads whole blocks of the file at a time.
void GdalRaster::read(const std::function<bool(Result<std::vector<float>>)>& take) {
    constexpr int fewestRows = 64;
    int blockWidth = 0, blockHeight = 0;
    GDALGetBlockSize(_band, &blockWidth, &blockHeight);
    blockHeight = std::max(blockHeight, 1);
    const int most = blockHeight * std::max(1, fewestRows / blockHeight);
    for (int first = 0; first < _rows; first += most) {
        Result<std::vector<float>> some = rows(first, std::min(most, _rows - first));
        const bool isGood = some.ok();
        if (!take(std::move(some)) || !isGood)
            return;
    }
}

Result<std::vector<float>> GdalRaster::rows(int first, int count) {
    std::vector<float> heights(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(count));
    if (!readRows(_band, first, count, _columns, heights.data()) || !_errors.text().empty())
        return problem("reading failed: " + _errors.textOr("the file is truncated"));
    if (const std::string odd = convertToMetres(heights, first); !odd.empty())
        return problem(odd);
    return heights;
}

/// Converts heights to metres. @return a problem; empty on success.
std::string GdalRaster::convertToMetres(std::vector<float>& heights, int firstRow) const {
    const auto columns = static_cast<std::size_t>(_columns);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double height = _scale * static_cast<double>(heights[i]) + _offset;
        const bool isHole = std::isnan(height);
        if (!isHole && !heightRange.contains(height))
            return "expected heights " + heightRange.text() + " metres, found " + numberText(height) +
                   " in column " + std::to_string(i % columns) + ", row " +
                   std::to_string(static_cast<std::size_t>(firstRow) + i / columns) +
                   "; a value for missing heights has to be the nodata value of the file";
        heights[i] = isHole ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(height);
    }
    return {};
}

bool readRows(void* band, int first, int count, int columns, float* values) {
    if (GDALRasterIO(band, GF_Read, 0, first, columns, count, values, columns, count, GDT_Float32, 0, 0) !=
        CE_None)
        return false;
    if (GDALGetMaskFlags(band) & GMF_ALL_VALID)
        return true;
    std::vector<unsigned char> valid(static_cast<std::size_t>(columns) * static_cast<std::size_t>(count));
    if (GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, first, columns, count, valid.data(), columns, count,
                     GDT_Byte, 0, 0) != CE_None)
        return false;
    for (std::size_t i = 0; i < valid.size(); ++i)
        if (valid[i] == 0)
            values[i] = std::numeric_limits<float>::quiet_NaN();
    return true;
}

} // namespace osgTreeWind
