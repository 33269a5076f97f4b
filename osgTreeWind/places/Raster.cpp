// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Raster.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/GdalErrors.h>

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr double mostCells = 4e8;

/// Formats that are read by libraries which break on damaged files.
bool isFragile(const std::string& format) {
    const std::string name = lower(format);
    return name.rfind("hdf", 0) == 0 || name.rfind("netcdf", 0) == 0 || name == "bag" || name == "gmt" ||
           name == "kea" || name == "grib";
}

/// All others, for GDAL.
std::vector<const char*> soundFormats() {
    std::vector<const char*> formats;
    for (int i = 0; i < GDALGetDriverCount(); ++i)
        if (const char* const name = GDALGetDriverShortName(GDALGetDriver(i)); !isFragile(name))
            formats.push_back(name);
    formats.push_back(nullptr);
    return formats;
}

/// Why GDAL does not open a file.
std::string problemOfFormat(const std::string& path, const GdalErrors& errors) {
    const GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
    if (driver && isFragile(GDALGetDriverShortName(driver)))
        return std::string("expected another format than ") + GDALGetDriverShortName(driver) +
               ", which a damaged file may break; gdal_translate makes a GeoTIFF of it";
    return "cannot be read: " + errors.textOr("GDAL knows no such format");
}
constexpr Range heightRange = within(-12000, 30000); // metres: what is none stands out

/// Metres; nothing for a unit that is not known.
std::optional<double> unitOfHeights(GDALRasterBandH band, OGRSpatialReferenceH reference) {
    const std::string name = lower(GDALGetRasterUnitType(band));
    const auto isOneOf = [&](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (name.empty())
        return reference && OSRIsCompound(reference)
                   ? OSRGetTargetLinearUnits(reference, "COMPD_CS|VERT_CS", nullptr)
                   : 1.0;
    if (isOneOf({"m", "metre", "metres", "meter", "meters"}))
        return 1.0;
    if (isOneOf({"ft", "foot", "feet", "international foot", "ift"}))
        return 0.3048;
    if (isOneOf({"us-ft", "us survey foot", "us survey feet", "foot_us", "ftus", "us_survey_foot"}))
        return 1200.0 / 3937.0;
    if (isOneOf({"cm", "centimetre", "centimetres", "centimeter", "centimeters"}))
        return 0.01;
    return std::nullopt;
}

} // namespace

/// A raster while it is read.
struct Raster::Reading {
    Raster& raster;
    GDALDatasetH data;
    GDALRasterBandH band = nullptr;
    double scale = 1.0, offset = 0.0;
    const GdalErrors& errors;

    Diagnostics problem(const std::string& message) const { return {fileProblem(raster._path, message)}; }

    Diagnostics readHead();
    Diagnostics chooseBand();
    Diagnostics readCells();
    Diagnostics takeRows(int first, int count, const std::vector<unsigned char>& valid);
};

Diagnostics Raster::Reading::readHead() {
    raster._columns = GDALGetRasterXSize(data);
    raster._rows = GDALGetRasterYSize(data);
    if (Diagnostics problems = chooseBand(); !problems.empty())
        return problems;
    if (static_cast<double>(raster._columns) * raster._rows > mostCells)
        return problem("expected at most " + numberText(mostCells) + " cells, found " +
                       std::to_string(raster._columns) + " x " + std::to_string(raster._rows) +
                       "; gdal_translate -projwin cuts a part out");
    std::array<double, 6>& toPlace = raster._toPlace;
    if (GDALGetGeoTransform(data, toPlace.data()) != CE_None)
        return problem("it does not say where it lies: expected a geotransform");
    if (!std::all_of(toPlace.begin(), toPlace.end(), [](double x) { return std::isfinite(x); }) ||
        !GDALInvGeoTransform(toPlace.data(), raster._toCell.data()))
        return problem("its cells have no extent");
    const OGRSpatialReferenceH reference = GDALGetSpatialRef(data);
    const auto unit = unitOfHeights(band, reference);
    if (!unit)
        return problem("expected heights in metres or feet, found the unit " +
                       inQuotes(GDALGetRasterUnitType(band)));
    if (reference && !OSRIsLocal(reference))
        raster._crs = Crs(OSRClone(reference));
    scale = GDALGetRasterScale(band, nullptr) * *unit;
    offset = GDALGetRasterOffset(band, nullptr) * *unit;
    return {};
}

Diagnostics Raster::Reading::chooseBand() {
    int bands = 0;
    for (int i = GDALGetRasterCount(data); i > 0; --i)
        if (const GDALRasterBandH each = GDALGetRasterBand(data, i);
            GDALGetRasterColorInterpretation(each) != GCI_AlphaBand) {
            band = each;
            ++bands;
        }
    if (bands != 1)
        return problem("expected one band of heights, found " + std::to_string(bands));
    if (GDALGetRasterColorInterpretation(band) == GCI_PaletteIndex)
        return problem("expected heights, found colours of a palette");
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(band)))
        return problem("expected heights, found complex numbers");
    return {};
}

/// Rows of whole blocks, as they lie in the file.
Diagnostics Raster::Reading::readCells() {
    constexpr int fewestRows = 64;
    int blockWidth = 0, blockHeight = 0;
    GDALGetBlockSize(band, &blockWidth, &blockHeight);
    blockHeight = std::max(blockHeight, 1);
    const int most = blockHeight * std::max(1, fewestRows / blockHeight);
    const bool hasHoles = !(GDALGetMaskFlags(band) & GMF_ALL_VALID);
    const auto columns = static_cast<std::size_t>(raster._columns);
    raster._heights.reserve(columns * static_cast<std::size_t>(raster._rows));
    std::vector<unsigned char> valid;
    for (int first = 0; first < raster._rows; first += most) {
        const int count = std::min(most, raster._rows - first);
        const std::size_t before = raster._heights.size(), cells = columns * static_cast<std::size_t>(count);
        raster._heights.resize(before + cells);
        bool isRead =
            GDALRasterIO(band, GF_Read, 0, first, raster._columns, count, raster._heights.data() + before,
                         raster._columns, count, GDT_Float32, 0, 0) == CE_None;
        if (hasHoles) {
            valid.resize(cells);
            isRead = isRead && GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, first, raster._columns, count,
                                            valid.data(), raster._columns, count, GDT_Byte, 0, 0) == CE_None;
        }
        if (!isRead || !errors.text().empty())
            return problem("cannot be read on: " + errors.textOr("it ends early"));
        if (Diagnostics problems = takeRows(first, count, valid); !problems.empty())
            return problems;
    }
    return {};
}

/// Makes metres of what was read. @param valid 0: a hole; empty: there are none.
Diagnostics Raster::Reading::takeRows(int first, int count, const std::vector<unsigned char>& valid) {
    const auto columns = static_cast<std::size_t>(raster._columns),
               cells = columns * static_cast<std::size_t>(count);
    float* heights = raster._heights.data() + static_cast<std::size_t>(first) * columns;
    for (std::size_t i = 0; i < cells; ++i) {
        const double height = scale * static_cast<double>(heights[i]) + offset;
        const bool isHole = std::isnan(height) || (!valid.empty() && valid[i] == 0);
        if (!isHole && !heightRange.contains(height))
            return problem("expected heights " + heightRange.text() + " metres, found " + numberText(height) +
                           " in column " + std::to_string(i % columns) + ", row " +
                           std::to_string(static_cast<std::size_t>(first) + i / columns) +
                           "; where that means that there is none, it has to be the file's nodata");
        heights[i] = isHole ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(height);
    }
    return {};
}

Result<Raster> Raster::open(const std::string& path) {
    registerGdal();
    const GdalErrors errors;
    Raster raster;
    raster._path = path;
    const std::unique_ptr<void, decltype(&GDALClose)> data(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                   soundFormats().data(), nullptr, nullptr),
        &GDALClose);
    if (!data || !errors.text().empty())
        return fileProblem(path, problemOfFormat(path, errors));
    Reading reading{raster, data.get(), nullptr, 1.0, 0.0, errors};
    Diagnostics problems = reading.readHead();
    if (problems.empty())
        problems = reading.readCells();
    if (!problems.empty())
        return problems;
    return raster;
}

glm::dvec2 Raster::placeOf(const glm::dvec2& cell) const {
    glm::dvec2 place;
    GDALApplyGeoTransform(const_cast<double*>(_toPlace.data()), cell.x, cell.y, &place.x, &place.y);
    return place;
}

std::optional<double> Raster::height(const glm::dvec2& place) const {
    constexpr double rounding = 1e-6; // cells; of places on the edge, and of those on a centre beside a hole
    glm::dvec2 cell;
    GDALApplyGeoTransform(const_cast<double*>(_toCell.data()), place.x, place.y, &cell.x, &cell.y);
    if (!(cell.x >= -rounding && cell.x <= _columns + rounding && cell.y >= -rounding &&
          cell.y <= _rows + rounding))
        return std::nullopt;
    const double u = std::clamp(cell.x - 0.5, 0.0, _columns - 1.0),
                 v = std::clamp(cell.y - 0.5, 0.0, _rows - 1.0);
    double height = 0.0, weights = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = std::floor(u) + (corner & 1), y = std::floor(v) + (corner >> 1),
                     weight = (1.0 - std::abs(u - x)) * (1.0 - std::abs(v - y));
        if (weight <= rounding)
            continue;
        const float known = _heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(_columns) +
                                     static_cast<std::size_t>(x)];
        if (std::isnan(known))
            return std::nullopt;
        height += weight * static_cast<double>(known);
        weights += weight;
    }
    return height / weights;
}

} // namespace osgTreeWind
