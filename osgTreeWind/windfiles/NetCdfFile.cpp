// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/NetCdfFile.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <cpl_error.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace osgTreeWind {

namespace {

constexpr double bestRatio = 1100.0;     // deflate cannot do better than 1032 to 1
constexpr double mostNumbers = 1u << 29; // of one array

double countOf(const NetCdfFile::Array& array) {
    double count = 1.0;
    for (const auto& dimension : array->GetDimensions())
        count *= static_cast<double>(dimension->GetSize());
    return count;
}

bool readInto(const NetCdfFile::Array& array, GDALDataType type, void* numbers) {
    const std::vector<GUInt64> starts(array->GetDimensionCount(), 0);
    std::vector<std::size_t> counts;
    for (const auto& dimension : array->GetDimensions())
        counts.push_back(static_cast<std::size_t>(dimension->GetSize()));
    return array->Read(starts.data(), counts.data(), nullptr, nullptr, GDALExtendedDataType::Create(type),
                       numbers);
}

/// Seconds in a unit of time such as "hours" or "Hour"; nothing for another.
std::optional<double> secondsOf(const std::string& unit) {
    static const std::pair<const char*, double> units[] = {
        {"s", 1.0},    {"sec", 1.0},   {"second", 1.0},  {"min", 60.0},  {"minute", 60.0},
        {"h", 3600.0}, {"hr", 3600.0}, {"hour", 3600.0}, {"d", 86400.0}, {"day", 86400.0}};
    const std::string name = lower(unit);
    for (const auto& [known, seconds] : units)
        if (name == known || name == std::string(known) + "s")
            return seconds;
    return std::nullopt;
}

} // namespace

NetCdfFile::NetCdfFile(const std::string& path) : _path(path) {
    GDALAllRegister();
    const char* const drivers[] = {"netCDF", nullptr};
    std::error_code ignored;
    _bytes = static_cast<double>(std::filesystem::file_size(path, ignored));
    _dataset.reset(GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER, drivers));
    _root = _dataset ? _dataset->GetRootGroup() : nullptr;
    if (!_root)
        fail({}, std::string("no NetCDF file that GDAL can read: ") + CPLGetLastErrorMsg());
}

void NetCdfFile::fail(const std::string& array, const std::string& message) {
    if (good())
        _problem = {_path, 0, 0, array, message};
}

NetCdfFile::Array NetCdfFile::array(const std::string& name) const {
    return _root ? _root->OpenMDArray(name) : nullptr;
}

NetCdfFile::Array NetCdfFile::find(const std::function<bool(const Array&)>& condition) const {
    for (const std::string& name : _root ? _root->GetMDArrayNames() : std::vector<std::string>())
        if (Array found = array(name); found && condition(found))
            return found;
    return nullptr;
}

std::string NetCdfFile::text(const Array& array, const char* attribute) {
    const auto found = array->GetAttribute(attribute);
    const char* value = found ? found->ReadAsString() : nullptr;
    return value ? value : "";
}

std::optional<double> NetCdfFile::number(const char* attribute) const {
    const auto found = _root ? _root->GetAttribute(attribute) : nullptr;
    const double value = found ? found->ReadAsDouble() : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

double NetCdfFile::positive(const char* attribute) {
    const double value = number(attribute).value_or(0.0);
    if (value > 0.0 && value < 1e9)
        return value;
    fail(attribute, "expected this attribute of the file, above 0");
    return 1.0;
}

std::vector<float> NetCdfFile::read(const Array& array, double count) {
    if (!good())
        return {};
    const double found = countOf(array);
    if (found != count)
        fail(array->GetName(), "expected " + numberText(count) + " numbers, found " + numberText(found));
    else if (count > mostNumbers || 2.0 * count > bestRatio * _bytes)
        fail(array->GetName(), "the file is too short for " + numberText(count) + " numbers");
    if (!good())
        return {};
    std::vector<float> numbers(static_cast<std::size_t>(count));
    if (!readInto(array, GDT_Float32, numbers.data())) {
        fail(array->GetName(), std::string("cannot be read: ") + CPLGetLastErrorMsg());
        return {};
    }
    bool packed = false, marked = false;
    const double scale = array->GetScale(&packed), offset = array->GetOffset();
    const float missing = static_cast<float>(array->GetNoDataValueAsDouble(&marked));
    for (float& number : numbers) {
        if (marked && number == missing)
            number = std::numeric_limits<float>::quiet_NaN();
        else if (packed)
            number = static_cast<float>(number * scale + offset);
    }
    return numbers;
}

std::vector<double> NetCdfFile::readDoubles(const Array& array) {
    const double count = countOf(array);
    if (!good() || array->GetDimensionCount() != 1 || count > bestRatio * _bytes) {
        fail(array->GetName(), "expected an array of one dimension");
        return {};
    }
    std::vector<double> numbers(static_cast<std::size_t>(count));
    if (!readInto(array, GDT_Float64, numbers.data()))
        fail(array->GetName(), std::string("cannot be read: ") + CPLGetLastErrorMsg());
    for (double number : numbers)
        if (!std::isfinite(number))
            fail(array->GetName(), "expected finite coordinates");
    return good() ? numbers : std::vector<double>();
}

NetCdfFile::Array NetCdfFile::coordinates(const Dimension& dimension) const {
    const Array indexing = dimension->GetIndexingVariable();
    return indexing ? indexing : array(dimension->GetName());
}

std::vector<double> NetCdfFile::metres(const Dimension& dimension) {
    const Array array = coordinates(dimension);
    if (!good() || !array)
        return {};
    const std::string unit = array->GetUnit();
    double scale = 1.0;
    if (unit == "km" || unit == "kilometer" || unit == "kilometers")
        scale = 1000.0;
    else if (!unit.empty() && unit != "m" && unit != "meter" && unit != "meters" && unit != "metre" &&
             unit != "metres")
        fail(array->GetName(), expectedFound("coordinates in m or km", unit));
    std::vector<double> numbers = readDoubles(array);
    for (double& number : numbers)
        number *= scale;
    return numbers;
}

std::vector<double> NetCdfFile::seconds(const Array& times, std::string& start) {
    std::string unit = times->GetUnit();
    if (unit.empty())
        unit = text(times, "units");
    const std::size_t since = unit.find(" since ");
    const auto scale = secondsOf(unit.substr(0, since));
    if (!scale)
        fail(times->GetName(), expectedFound("times in seconds, minutes, hours or days", unit));
    std::vector<double> numbers = readDoubles(times);
    if (numbers.empty())
        return {};
    if (since != std::string::npos)
        start = numberText(numbers.front()) + " " + unit;
    const double first = numbers.front();
    for (double& number : numbers)
        number = (number - first) * scale.value_or(1.0);
    return numbers;
}

std::string NetCdfFile::speedUnitOf(const std::vector<Array>& arrays) {
    std::string unit;
    for (const Array& array : arrays) {
        const std::string found = usualSpeedUnit(array->GetUnit());
        if (array != arrays.front() && found != unit)
            fail(array->GetName(), expectedFound("the unit of the other components, " + unit, found));
        unit = found;
        if (const auto known = speedUnit(unit); !unit.empty() && !known)
            fail(array->GetName(), known.problems().front().message);
    }
    return unit;
}

Projection::Projection(const OGRSpatialReference& projection) {
    OGRSpatialReference map(projection);
    const std::unique_ptr<OGRSpatialReference> globe(map.CloneGeogCS());
    if (!globe)
        return;
    map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    globe->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    toMap.reset(OGRCreateCoordinateTransformation(globe.get(), &map));
    toGlobe.reset(OGRCreateCoordinateTransformation(&map, globe.get()));
    if (!toGlobe)
        toMap = nullptr;
}

} // namespace osgTreeWind
