// SPDX-License-Identifier: MIT
#include <plugins/weather/GribValues.h>

#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>
#include <plugins/weather/GribChoice.h>
#include <plugins/weather/GribHandle.h>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

namespace osgTreeWind {

namespace {

EvenAxis axisOf(double corner, double step, int count) {
    return {corner + 0.5 * step, step, static_cast<std::size_t>(count), 0.0};
}

/// A GRIB message opened by GDAL from memory.
class GdalMessage {
public:
    explicit GdalMessage(std::string bytes) : _bytes(std::move(bytes)) {
        GDALRegister_GRIB();                          // registering every driver takes longer
        CPLSetConfigOption("GDAL_PAM_ENABLED", "NO"); // do not read .aux.xml files beside it
        const char* const drivers[] = {"GRIB", nullptr};
        const char* const options[] = {"USE_IDX=NO", nullptr};
        VSIFCloseL(VSIFileFromMemBuffer(name, reinterpret_cast<GByte*>(_bytes.data()), _bytes.size(), FALSE));
        _data = GDALOpenEx(name, GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers, options, nullptr);
    }
    GdalMessage(const GdalMessage&) = delete;
    GdalMessage& operator=(const GdalMessage&) = delete;
    ~GdalMessage() {
        if (_data)
            GDALClose(_data);
        VSIUnlink(name);
    }

    void* get() const { return _data; }

private:
    static constexpr const char* name = "/vsimem/field";
    std::string _bytes;
    void* _data;
};

/// A message of GDAL without the name of the memory file.
std::string reasonOf(std::string text) {
    for (std::size_t at; (at = text.find("/vsimem/")) != std::string::npos;)
        text.erase(at, std::strlen("/vsimem/"));
    return text.empty() ? "" : ": " + text;
}

} // namespace

Diagnostic GribValues::problem(const GribField& field, const std::string& message) const {
    return {_path, 0, 0, textOf(field), message};
}

Result<GribGeoreference> GribValues::georeference(const GribField& field) {
    if (!field.grid.isEven)
        return problem(field,
                       "its grid is " + field.grid.kind +
                           ", whose points are not evenly spaced in longitude and latitude or on a map; "
                           "convert it with `cdo remapbil`");
    std::string bytes = GribHandle(field.parts).withZeroValues(field.grid.columns * field.grid.rows);
    if (bytes.empty())
        if (const auto numbers = read(field, {}, {}); !numbers)
            return numbers.problems();
    const GdalErrors errors;
    const GdalMessage message(std::move(bytes));
    void* const data = message.get();
    if (!data)
        return problem(field, "GDAL cannot place its grid, " + field.grid.kind + reasonOf(errors.text()));
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
        return problem(field, "GDAL cannot place its grid, " + field.grid.kind +
                                  reasonOf(errors.warnings().empty() ? "" : errors.warnings().front()));
    const GdalCrs crs(OSRClone(reference));
    OSRSetAxisMappingStrategy(crs.reference(), OAMS_TRADITIONAL_GIS_ORDER);
    GribGeoreference found{crs.crs(), {}, axisOf(at[0], at[1], columns), axisOf(at[3], at[5], rows)};
    found.name = projText(found.crs);
    if (found.crs.isDegrees())
        found.x.period = 360.0;
    return _georeference = found;
}

Result<std::vector<float>> GribValues::read(const GribField& field, const AxisPart& x,
                                            const AxisPart& y) const {
    const GribHandle handle(field.parts);
    const std::size_t columns = field.grid.columns, rows = field.grid.rows;
    std::vector<double> numbers(columns * rows);
    if (const auto reason = handle.readValues(numbers))
        return problem(field, "its values, packed as " + handle.text("packingType") +
                                  ", cannot be read: " + *reason);
    const auto is = [&](const char* flag) { return handle.integer(flag).value_or(0) != 0; };
    const bool westward = is("iScansNegatively"), northward = is("jScansPositively"),
               byColumns = is("jPointsAreConsecutive"), alternating = is("alternativeRowScanning");
    const double west =
        handle.real(westward ? "longitudeOfLastGridPointInDegrees" : "longitudeOfFirstGridPointInDegrees");
    // GDAL counts longitudes around the globe from -180.
    const bool isGlobe =
        _georeference.x.period > 0.0 &&
        std::abs(static_cast<double>(columns) * _georeference.x.step - 360.0) < 0.5 * _georeference.x.step;
    const double turn = isGlobe ? std::round((_georeference.x.first - west) / _georeference.x.step) : 0.0;
    const auto shift = static_cast<std::size_t>(turn - std::floor(turn / static_cast<double>(columns)) *
                                                           static_cast<double>(columns));
    std::vector<float> values;
    values.reserve(x.indices.size() * y.indices.size());
    for (const std::size_t southward : y.indices)
        for (const std::size_t eastward : x.indices) {
            std::size_t row = northward ? rows - 1 - southward : southward,
                        column = (eastward + shift) % columns;
            if (westward)
                column = columns - 1 - column;
            if (alternating && !byColumns && row % 2 == 1)
                column = columns - 1 - column;
            if (alternating && byColumns && column % 2 == 1)
                row = rows - 1 - row;
            values.push_back(
                static_cast<float>(numbers[byColumns ? column * rows + row : row * columns + column]));
        }
    return values;
}

} // namespace osgTreeWind
