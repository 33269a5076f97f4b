// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <cpl_error.h>
#include <cpl_string.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace osgTreeWind {

namespace {

constexpr double bestRatio = 1100.0;     // deflate cannot do better than 1032 to 1
constexpr double mostNumbers = 1u << 29; // of one array

double countOf(const NetCdfArray& array) {
    double count = 1.0;
    for (const NetCdfDimension& dimension : array.dimensions)
        count *= static_cast<double>(dimension.size);
    return count;
}

/// @param bytes of all numbers together.
bool readInto(const NetCdfArray& array, GDALDataType type, void* numbers, std::size_t bytes) {
    const std::vector<GUInt64> starts(array.dimensions.size(), 0);
    std::vector<std::size_t> counts;
    for (const NetCdfDimension& dimension : array.dimensions)
        counts.push_back(dimension.size);
    const std::unique_ptr<std::remove_pointer_t<GDALExtendedDataTypeH>,
                          decltype(&GDALExtendedDataTypeRelease)>
        kind(GDALExtendedDataTypeCreate(type), &GDALExtendedDataTypeRelease);
    return GDALMDArrayRead(array.handle.get(), starts.data(), counts.data(), nullptr, nullptr, kind.get(),
                           numbers, numbers, bytes) != 0;
}

std::string textOf(const char* text) {
    return text ? text : "";
}

/// What GDAL said last.
std::string reason() {
    const std::string said = CPLGetLastErrorMsg();
    return said.empty() ? "damaged, or of a kind that it does not know" : said;
}

/// An attribute of an array or of a group.
template <typename Handle>
auto attributeOf(Handle handle, const char* name, GDALAttributeH (*get)(Handle, const char*)) {
    return std::unique_ptr<std::remove_pointer_t<GDALAttributeH>, decltype(&GDALAttributeRelease)>(
        get(handle, name), &GDALAttributeRelease);
}

std::vector<NetCdfDimension> dimensionsOf(GDALMDArrayH array) {
    std::size_t count = 0;
    GDALDimensionH* const handles = GDALMDArrayGetDimensions(array, &count);
    std::vector<NetCdfDimension> dimensions;
    for (std::size_t i = 0; i < count; ++i) {
        NetCdfDimension dimension;
        dimension.name = textOf(GDALDimensionGetName(handles[i]));
        dimension.size = static_cast<std::size_t>(GDALDimensionGetSize(handles[i]));
        dimension.temporal = textOf(GDALDimensionGetType(handles[i])) == GDAL_DIM_TYPE_TEMPORAL;
        const GDALMDArrayH indexing = GDALDimensionGetIndexingVariable(handles[i]);
        dimension.coordinates = indexing ? textOf(GDALMDArrayGetName(indexing)) : dimension.name;
        GDALMDArrayRelease(indexing);
        dimensions.push_back(dimension);
    }
    GDALReleaseDimensions(handles, count);
    return dimensions;
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

std::string NetCdfArray::text(const char* attribute) const {
    const auto found = attributeOf(handle.get(), attribute, &GDALMDArrayGetAttribute);
    return found ? textOf(GDALAttributeReadAsString(found.get())) : "";
}

std::optional<Projection> NetCdfArray::projection() const {
    const OGRSpatialReferenceH reference = GDALMDArrayGetSpatialRef(handle.get());
    return reference ? std::optional<Projection>(reference) : std::nullopt;
}

NetCdfFile::NetCdfFile(const std::string& path)
    : _dataset(nullptr, &GDALReleaseDataset), _root(nullptr, &GDALGroupRelease), _path(path) {
    GDALAllRegister();
    const char* const drivers[] = {"netCDF", nullptr};
    std::error_code ignored;
    _bytes = static_cast<double>(std::filesystem::file_size(path, ignored));
    _dataset.reset(GDALOpenEx(path.c_str(), GDAL_OF_MULTIDIM_RASTER, drivers, nullptr, nullptr));
    if (_dataset)
        _root.reset(GDALDatasetGetRootGroup(_dataset.get()));
    if (!_root)
        fail({}, "no NetCDF file that GDAL can read: " + reason());
}

void NetCdfFile::fail(const std::string& array, const std::string& message) {
    if (good())
        _problem = {_path, 0, 0, array, message};
}

NetCdfFile::Array NetCdfFile::array(const std::string& name) const {
    const GDALMDArrayH handle = _root ? GDALGroupOpenMDArray(_root.get(), name.c_str(), nullptr) : nullptr;
    if (!handle)
        return nullptr;
    return std::make_shared<const NetCdfArray>(NetCdfArray{{handle, &GDALMDArrayRelease},
                                                           textOf(GDALMDArrayGetName(handle)),
                                                           textOf(GDALMDArrayGetUnit(handle)),
                                                           dimensionsOf(handle)});
}

NetCdfFile::Array NetCdfFile::find(const std::function<bool(const NetCdfArray&)>& condition) const {
    const std::unique_ptr<char*, decltype(&CSLDestroy)> names(
        _root ? GDALGroupGetMDArrayNames(_root.get(), nullptr) : nullptr, &CSLDestroy);
    for (char** name = names.get(); name && *name; ++name)
        if (Array found = array(*name); found && condition(*found))
            return found;
    return nullptr;
}

std::optional<double> NetCdfFile::number(const char* attribute) const {
    if (!_root)
        return std::nullopt;
    const auto found = attributeOf(_root.get(), attribute, &GDALGroupGetAttribute);
    const double value =
        found ? GDALAttributeReadAsDouble(found.get()) : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

double NetCdfFile::positive(const char* attribute) {
    const double value = number(attribute).value_or(0.0);
    if (value > 0.0 && value < 1e9)
        return value;
    fail(attribute, "expected this attribute of the file, above 0");
    return 1.0;
}

std::vector<float> NetCdfFile::read(const NetCdfArray& array, double count) {
    if (!good())
        return {};
    const double found = countOf(array);
    if (found != count)
        fail(array.name, "expected " + numberText(count) + " numbers, found " + numberText(found));
    else if (count > mostNumbers || 2.0 * count > bestRatio * _bytes)
        fail(array.name, "the file is too short for " + numberText(count) + " numbers");
    if (!good())
        return {};
    std::vector<float> numbers(static_cast<std::size_t>(count));
    if (!readInto(array, GDT_Float32, numbers.data(), numbers.size() * sizeof(float))) {
        fail(array.name, "cannot be read: " + reason());
        return {};
    }
    int packed = 0, marked = 0;
    const GDALMDArrayH handle = array.handle.get();
    const double scale = GDALMDArrayGetScale(handle, &packed), offset = GDALMDArrayGetOffset(handle, nullptr);
    const auto missing = static_cast<float>(GDALMDArrayGetNoDataValueAsDouble(handle, &marked));
    for (float& number : numbers) {
        if (marked && number == missing)
            number = std::numeric_limits<float>::quiet_NaN();
        else if (packed)
            number = static_cast<float>(number * scale + offset);
    }
    return numbers;
}

std::vector<double> NetCdfFile::readDoubles(const NetCdfArray& array) {
    const double count = countOf(array);
    if (!good() || array.dimensions.size() != 1 || count > bestRatio * _bytes) {
        fail(array.name, "expected an array of one dimension");
        return {};
    }
    std::vector<double> numbers(static_cast<std::size_t>(count));
    if (!readInto(array, GDT_Float64, numbers.data(), numbers.size() * sizeof(double)))
        fail(array.name, "cannot be read: " + reason());
    for (double number : numbers)
        if (!std::isfinite(number))
            fail(array.name, "expected finite coordinates");
    return good() ? numbers : std::vector<double>();
}

std::vector<double> NetCdfFile::metres(const NetCdfDimension& dimension) {
    const Array found = array(dimension.coordinates);
    if (!good() || !found)
        return {};
    const std::string& unit = found->unit;
    double scale = 1.0;
    if (unit == "km" || unit == "kilometer" || unit == "kilometers")
        scale = 1000.0;
    else if (!unit.empty() && unit != "m" && unit != "meter" && unit != "meters" && unit != "metre" &&
             unit != "metres")
        fail(found->name, expectedFound("coordinates in m or km", unit));
    std::vector<double> numbers = readDoubles(*found);
    for (double& number : numbers)
        number *= scale;
    return numbers;
}

std::vector<double> NetCdfFile::seconds(const NetCdfArray& times, std::string& start) {
    const std::string unit = times.unit.empty() ? times.text("units") : times.unit;
    const std::size_t since = unit.find(" since ");
    const auto scale = secondsOf(unit.substr(0, since));
    if (!scale)
        fail(times.name, expectedFound("times in seconds, minutes, hours or days", unit));
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
        const std::string found = usualSpeedUnit(array->unit);
        if (array != arrays.front() && found != unit)
            fail(array->name, expectedFound("the unit of the other components, " + unit, found));
        unit = found;
        if (const auto known = speedUnit(unit); !unit.empty() && !known)
            fail(array->name, known.problems().front().message);
    }
    return unit;
}

} // namespace osgTreeWind
