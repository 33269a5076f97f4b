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

/// The order of the values of a message.
struct ScanOrder {
    std::size_t columns, rows;
    bool westward, northward, byColumns, alternating;

    /// Index of a point whose column is counted eastward and row southward.
    std::size_t indexOf(std::size_t column, std::size_t row) const {
        if (westward)
            column = columns - 1 - column;
        if (northward)
            row = rows - 1 - row;
        if (alternating && !byColumns && row % 2 == 1)
            column = columns - 1 - column;
        if (alternating && byColumns && column % 2 == 1)
            row = rows - 1 - row;
        return byColumns ? column * rows + row : row * columns + column;
    }
};

/// Columns from the first one of a message to the first one of GDAL, which starts the globe at -180 degrees.
std::size_t columnsToStart(double west, const EvenAxis& x) {
    const auto columns = static_cast<double>(x.count);
    if (x.period == 0.0 || std::abs(columns * x.step - x.period) >= 0.5 * x.step)
        return 0;
    const double turn = std::round((x.first - west) / x.step);
    return static_cast<std::size_t>(turn - std::floor(turn / columns) * columns);
}

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
    const auto is = [&](const char* flag) { return handle.integer(flag) != 0; };
    const ScanOrder order{field.grid.columns,          field.grid.rows,
                          is("iScansNegatively"),      is("jScansPositively"),
                          is("jPointsAreConsecutive"), is("alternativeRowScanning")};
    std::vector<double> numbers(order.columns * order.rows);
    if (const auto reason = handle.readValues(numbers))
        return problem(field, "its values, packed as " + handle.text("packingType") +
                                  ", cannot be read: " + *reason);
    const double west = handle.real(order.westward ? "longitudeOfLastGridPointInDegrees"
                                                   : "longitudeOfFirstGridPointInDegrees");
    const std::size_t shift = columnsToStart(west, _georeference.x);
    std::vector<float> values;
    values.reserve(x.indices.size() * y.indices.size());
    for (const std::size_t row : y.indices)
        for (const std::size_t column : x.indices)
            values.push_back(
                static_cast<float>(numbers[order.indexOf((column + shift) % order.columns, row)]));
    return values;
}

} // namespace osgTreeWind
