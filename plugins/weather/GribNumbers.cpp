// SPDX-License-Identifier: MIT
#include <plugins/weather/GribNumbers.h>

#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>
#include <plugins/weather/GribChoice.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

/// Neighbouring points of an axis that lie one after another in the file.
struct PointRun {
    int first = 0, count = 0;
};

std::vector<PointRun> pointRuns(const std::vector<std::size_t>& indices) {
    std::vector<PointRun> runs;
    for (const std::size_t index : indices) {
        const int at = static_cast<int>(index);
        if (runs.empty() || at != runs.back().first + runs.back().count)
            runs.push_back({at, 0});
        ++runs.back().count;
    }
    return runs;
}

EvenAxis axisOf(double corner, double step, int count) {
    return {corner + 0.5 * step, step, static_cast<std::size_t>(count), 0.0};
}

constexpr const char* otherPacking =
    "; `grib_set -r -s packingType=grid_simple` of ecCodes packs them otherwise";

std::string projText(const Crs& crs) {
    const GdalErrors errors;
    char* text = nullptr;
    const Result<GdalCrs> known = GdalCrs::parse(crs.text());
    const OGRErr error = known ? OSRExportToProj4(known.value().reference(), &text) : OGRERR_FAILURE;
    std::string name = error == OGRERR_NONE && text && *text ? text : crs.name();
    CPLFree(text);
    return name;
}

} // namespace

GribNumbers::GribNumbers(std::string path) : _path(std::move(path)) {
    registerGdal();
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO"); // what stands beside the file is none of it
}

Diagnostic GribNumbers::problem(const GribField& field, const std::string& message) const {
    return {_path, 0, 0, textOf(field), message};
}

void* GribNumbers::open(const GribField& field) {
    const GdalErrors errors;
    if (!_data || _begin != field.begin) {
        const std::string message =
            "/vsisubfile/" + std::to_string(field.begin) + '_' + std::to_string(field.size) + ',' + _path;
        const char* const drivers[] = {"GRIB", nullptr};
        const char* const options[] = {"USE_IDX=NO", nullptr};
        const char* const siblings[] = {nullptr};
        _data.reset(
            GDALOpenEx(message.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers, options, siblings),
            [](void* data) {
                if (data)
                    GDALClose(data);
            });
        _begin = field.begin;
        _warning = errors.warnings().empty() ? "" : ": " + errors.warnings().front();
    }
    if (_data && errors.text().empty() && field.band <= GDALGetRasterCount(_data.get()))
        return _data.get();
    _data.reset();
    _reason = "its numbers, packed " + field.packing +
              ", cannot be read: " + errors.textOr("GDAL does not know what is in it");
    if (_reason.back() == '.')
        _reason.pop_back();
    if (field.packing == "by CCSDS")
        _reason += otherPacking;
    for (std::size_t at; (at = _reason.find("/vsisubfile/")) != std::string::npos;)
        _reason.erase(at, _reason.find(',', at) + 1 - at);
    return nullptr;
}

Result<GribPlace> GribNumbers::place(const GribField& field) {
    if (!field.grid.even)
        return problem(field, "its grid is " + field.grid.kind +
                                  ", whose points are not even on longitudes and latitudes or on a map; "
                                  "`cdo remapbil` makes an even grid of it");
    void* const data = open(field);
    if (!data)
        return problem(field, _reason);
    const int columns = GDALGetRasterXSize(data), rows = GDALGetRasterYSize(data);
    if (static_cast<std::uint64_t>(columns) != field.grid.columns ||
        static_cast<std::uint64_t>(rows) != field.grid.rows)
        return problem(field, "its sections say " + std::to_string(field.grid.columns) + " x " +
                                  std::to_string(field.grid.rows) + " points, GDAL reads " +
                                  std::to_string(columns) + " x " + std::to_string(rows));
    std::array<double, 6> at{};
    const OGRSpatialReferenceH reference = GDALGetSpatialRef(data);
    const bool isPlaced = GDALGetGeoTransform(data, at.data()) == CE_None && reference &&
                          std::all_of(at.begin(), at.end(), [](double each) { return std::isfinite(each); });
    if (!isPlaced || at[1] == 0.0 || at[5] == 0.0 || at[2] != 0.0 || at[4] != 0.0)
        return problem(field, "GDAL cannot place its grid, " + field.grid.kind + _warning);
    const GdalCrs crs(OSRClone(reference));
    OSRSetAxisMappingStrategy(crs.reference(), OAMS_TRADITIONAL_GIS_ORDER);
    GribPlace place{crs.crs(), {}, axisOf(at[0], at[1], columns), axisOf(at[3], at[5], rows)};
    place.name = projText(place.crs);
    if (place.crs.isDegrees())
        place.x.period = 360.0;
    return place;
}

Result<std::vector<float>> GribNumbers::read(const GribField& field, const AxisPart& x, const AxisPart& y,
                                             const std::vector<std::string>& units) {
    if (!field.unpackable)
        return problem(field, "its numbers are packed " + field.packing + ", which GDAL does not unpack" +
                                  otherPacking);
    void* const data = open(field);
    if (!data)
        return problem(field, _reason);
    const GDALRasterBandH band = GDALGetRasterBand(data, field.band);
    const GdalErrors errors;
    const auto [low, high] = std::minmax_element(y.indices.begin(), y.indices.end());
    const int top = static_cast<int>(*low), rows = static_cast<int>(*high - *low) + 1;
    const std::size_t columns = x.indices.size();
    std::vector<double> numbers(columns * static_cast<std::size_t>(rows));
    double* out = numbers.data();
    for (const PointRun& run : pointRuns(x.indices)) {
        const CPLErr error =
            GDALRasterIO(band, GF_Read, run.first, top, run.count, rows, out, run.count, rows, GDT_Float64,
                         sizeof(double), static_cast<int>(columns * sizeof(double)));
        if (error != CE_None || !errors.text().empty())
            return problem(field, "cannot be read: " + errors.textOr("its numbers are damaged"));
        out += run.count;
    }
    const std::string unit = orEmpty(GDALGetMetadataItem(band, "GRIB_UNIT", nullptr)),
                      valid = orEmpty(GDALGetMetadataItem(band, "GRIB_VALID_TIME", nullptr));
    if (std::find(units.begin(), units.end(), unit) == units.end())
        return problem(field, expectedFound("a unit of " + units.front(), unit));
    if (const auto time = parseNumber(valid.substr(0, valid.find(' '))); time && *time != field.valid)
        return problem(field, "GDAL takes it for another time, " + inQuotes(valid));
    int marked = 0;
    const double missing = GDALGetRasterNoDataValue(band, &marked);
    std::vector<float> values;
    values.reserve(columns * y.indices.size());
    for (const std::size_t row : y.indices)
        for (std::size_t column = 0; column < columns; ++column) {
            const double number = numbers[(row - *low) * columns + column];
            values.push_back(marked && number == missing ? std::numeric_limits<float>::quiet_NaN()
                                                         : static_cast<float>(number));
        }
    return values;
}

} // namespace osgTreeWind
