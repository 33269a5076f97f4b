// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfFile.h>

#include <plugins/map/GdalCrs.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>
#include <osgTreeWind/system/Path.h>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double maxDeflateRatio = 1100.0; // the limit of deflate is 1032
constexpr double maxNumbers = 1u << 29;    // of one array
constexpr float minFillValue = 9.9e36f;    // default fill values of the NetCDF library are larger

using Kind =
    std::unique_ptr<std::remove_pointer_t<GDALExtendedDataTypeH>, decltype(&GDALExtendedDataTypeRelease)>;

Kind kindOf(const NetCdfArray& array) {
    return {GDALMDArrayGetDataType(array.handle.get()), &GDALExtendedDataTypeRelease};
}

double countOf(const NetCdfArray& array) {
    double count = 1.0;
    for (const NetCdfDimension& dimension : array.dimensions)
        count *= static_cast<double>(dimension.size);
    return count;
}

bool readInto(const NetCdfArray& array, const NetCdfBlock& block, GDALDataType type, void* numbers,
              std::size_t bytes) {
    const std::vector<GUInt64> starts(block.starts.begin(), block.starts.end());
    const Kind kind(GDALExtendedDataTypeCreate(type), &GDALExtendedDataTypeRelease);
    return GDALMDArrayRead(array.handle.get(), starts.data(), block.counts.data(), nullptr, nullptr,
                           kind.get(), numbers, numbers, bytes) != 0;
}

/// The last message of GDAL.
std::string reason() {
    const std::string message = CPLGetLastErrorMsg();
    return message.empty() ? "damaged or unsupported" : message;
}

std::vector<NetCdfDimension> dimensionsOf(GDALMDArrayH array) {
    std::size_t count = 0;
    GDALDimensionH* const handles = GDALMDArrayGetDimensions(array, &count);
    std::vector<NetCdfDimension> dimensions;
    for (std::size_t i = 0; i < count; ++i) {
        NetCdfDimension dimension;
        dimension.name = orEmpty(GDALDimensionGetName(handles[i]));
        dimension.size = static_cast<std::size_t>(GDALDimensionGetSize(handles[i]));
        dimension.isTime = orEmpty(GDALDimensionGetType(handles[i])) == GDAL_DIM_TYPE_TEMPORAL;
        const GDALMDArrayH indexing = GDALDimensionGetIndexingVariable(handles[i]);
        dimension.coordinates = indexing ? orEmpty(GDALMDArrayGetName(indexing)) : dimension.name;
        GDALMDArrayRelease(indexing);
        dimensions.push_back(dimension);
    }
    GDALReleaseDimensions(handles, count);
    return dimensions;
}

} // namespace

NetCdfArray::Attribute NetCdfArray::attribute(const char* name) const {
    std::size_t count = 0;
    const char* const options[] = {"SHOW_ALL=YES", nullptr}; // also attributes that GDAL interprets itself
    GDALAttributeH* const all = GDALMDArrayGetAttributes(handle.get(), &count, options);
    Attribute found(nullptr, &GDALAttributeRelease);
    for (std::size_t i = 0; i < count; ++i) {
        if (!found && orEmpty(GDALAttributeGetName(all[i])) == name)
            found.reset(std::exchange(all[i], nullptr));
        GDALAttributeRelease(all[i]);
    }
    CPLFree(all);
    return found;
}

std::string NetCdfArray::text(const char* name) const {
    const Attribute found = attribute(name);
    return found ? orEmpty(GDALAttributeReadAsString(found.get())) : "";
}

std::optional<double> NetCdfArray::number(const char* name) const {
    const Attribute found = attribute(name);
    return found ? std::optional<double>(GDALAttributeReadAsDouble(found.get())) : std::nullopt;
}

std::optional<Crs> NetCdfArray::crs() const {
    const OGRSpatialReferenceH reference = GDALMDArrayGetSpatialRef(handle.get());
    if (!reference)
        return std::nullopt;
    OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
    if (OSRIsProjected(reference) && std::abs(OSRGetLinearUnits(reference, nullptr) - 1.0) > 1e-9)
        OSRSetLinearUnitsAndUpdateParameters(reference, "metre", 1.0);
    return GdalCrs(reference).crs();
}

bool NetCdfArray::is32BitFloat() const {
    return GDALExtendedDataTypeGetNumericDataType(kindOf(*this).get()) == GDT_Float32;
}

NetCdfFile::NetCdfFile(const std::string& path, const std::string& secondFile)
    : _root(nullptr, &GDALGroupRelease), _path(path) {
    GDALAllRegister();
    _isClassic = std::ifstream(toPath(path), std::ios::binary).get() == 'C';
    _root = open(path);
    if (_root && !secondFile.empty())
        open(secondFile);
}

NetCdfFile::Group NetCdfFile::open(const std::string& path) {
    const char* const drivers[] = {"netCDF", nullptr};
    std::error_code ignored;
    _bytes += static_cast<double>(std::filesystem::file_size(toPath(path), ignored));
    _datasets.emplace_back(GDALOpenEx(path.c_str(), GDAL_OF_MULTIDIM_RASTER, drivers, nullptr, nullptr),
                           &GDALReleaseDataset);
    Group root(_datasets.back() ? GDALDatasetGetRootGroup(_datasets.back().get()) : nullptr,
               &GDALGroupRelease);
    if (!root) {
        fail({}, "GDAL cannot read this NetCDF file: " + reason());
        return root;
    }
    const char* const options[] = {"SHOW_ZERO_DIM=YES", nullptr};
    const std::unique_ptr<char*, decltype(&CSLDestroy)> names(GDALGroupGetMDArrayNames(root.get(), options),
                                                              &CSLDestroy);
    for (char** name = names.get(); name && *name; ++name)
        if (const GDALMDArrayH handle = GDALGroupOpenMDArray(root.get(), *name, nullptr))
            _arrays.push_back(
                std::make_shared<const NetCdfArray>(NetCdfArray{{handle, &GDALMDArrayRelease},
                                                                *name,
                                                                orEmpty(GDALMDArrayGetUnit(handle)),
                                                                dimensionsOf(handle)}));
    return root;
}

void NetCdfFile::fail(const std::string& array, const std::string& message) {
    if (good())
        _problem = {_path, 0, 0, array, message};
}

NetCdfFile::Array NetCdfFile::array(const std::string& name) const {
    return find([&](const NetCdfArray& array) { return array.name == name; });
}

NetCdfFile::Array NetCdfFile::find(const std::function<bool(const NetCdfArray&)>& condition) const {
    for (const Array& array : _arrays)
        if (condition(*array))
            return array;
    return nullptr;
}

NetCdfArray::Attribute NetCdfFile::attribute(const char* name) const {
    return {_root ? GDALGroupGetAttribute(_root.get(), name) : nullptr, &GDALAttributeRelease};
}

std::optional<double> NetCdfFile::number(const char* name) const {
    const auto found = attribute(name);
    const double value =
        found ? GDALAttributeReadAsDouble(found.get()) : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

double NetCdfFile::positiveNumber(const char* name) {
    const double value = number(name).value_or(0.0);
    if (value > 0.0 && value < 1e9)
        return value;
    fail(name, "expected this attribute of the file, above 0");
    return 1.0;
}

std::string NetCdfFile::text(const char* name) const {
    const auto found = attribute(name);
    return found ? orEmpty(GDALAttributeReadAsString(found.get())) : "";
}

/// A classic file stores all numbers of an array. A compressed file omits chunks that were never written, so
/// only the numbers to be read can be checked.
bool NetCdfFile::canHold(const NetCdfArray& array, const NetCdfSelection& selection) {
    double count = 1.0;
    for (const auto& indices : selection)
        count *= static_cast<double>(indices.size());
    if (count > maxNumbers)
        fail(array.name, "expected at most " + numberText(maxNumbers) + " numbers to read, found " +
                             numberText(count) + "; choose a smaller area");
    const bool isShort =
        GDALExtendedDataTypeGetSize(kindOf(array).get()) <= 2; // GDAL may read bytes as 16 bits
    const double stored = _isClassic ? countOf(array) * (isShort ? 1.0 : 4.0) : 2.0 * count / maxDeflateRatio;
    if (stored > _bytes)
        fail(array.name,
             "the file is too short for " + numberText(_isClassic ? countOf(array) : count) + " numbers");
    return good();
}

std::vector<float> NetCdfFile::read(const NetCdfArray& array, const NetCdfSelection& selection) {
    if (!good() || !canHold(array, selection))
        return {};
    std::vector<float> numbers;
    const auto read = [&](const NetCdfBlock& block, float* into) {
        return readInto(array, block, GDT_Float32, into, countOf(block) * sizeof(float));
    };
    if (!readSelection(selection, read, numbers)) {
        fail(array.name, "cannot be read: " + reason());
        return {};
    }
    unpack(array, numbers);
    return numbers;
}

void NetCdfFile::unpack(const NetCdfArray& array, std::vector<float>& numbers) const {
    int packed = 0, shifted = 0;
    const GDALMDArrayH handle = array.handle.get();
    const double scale = GDALMDArrayGetScale(handle, &packed),
                 offset = GDALMDArrayGetOffset(handle, &shifted);
    // GDAL treats a fill value of NaN as 0 in packed numbers.
    const std::optional<double> filled = array.number("_FillValue"), missing = array.number("missing_value");
    const auto is = [](float number, const std::optional<double>& code) {
        return code && number == static_cast<float>(*code);
    };
    for (float& number : numbers) {
        if (is(number, filled) || is(number, missing) || std::abs(number) > minFillValue)
            number = std::numeric_limits<float>::quiet_NaN();
        else if (packed || shifted)
            number = static_cast<float>(number * (packed ? scale : 1.0) + (shifted ? offset : 0.0));
    }
}

std::vector<double> NetCdfFile::coordinates(const NetCdfArray& array) {
    const double count = countOf(array);
    if (!good() || array.dimensions.size() > 1 || count > maxDeflateRatio * _bytes) {
        fail(array.name, "expected an array of one dimension");
        return {};
    }
    std::vector<double> numbers(static_cast<std::size_t>(count));
    NetCdfBlock block;
    for (const NetCdfDimension& dimension : array.dimensions) {
        block.starts.push_back(0);
        block.counts.push_back(dimension.size);
    }
    if (!readInto(array, block, GDT_Float64, numbers.data(), numbers.size() * sizeof(double)))
        fail(array.name, "cannot be read: " + reason());
    int packed = 0, shifted = 0;
    const double scale = GDALMDArrayGetScale(array.handle.get(), &packed),
                 offset = GDALMDArrayGetOffset(array.handle.get(), &shifted);
    for (double& number : numbers) {
        if (packed || shifted)
            number = number * (packed ? scale : 1.0) + (shifted ? offset : 0.0);
        if (!std::isfinite(number) || std::abs(number) > minFillValue)
            fail(array.name, "expected finite coordinates");
    }
    return good() ? numbers : std::vector<double>();
}

std::string NetCdfFile::speedUnitOf(const std::vector<Array>& arrays) {
    std::string unit;
    for (const Array& array : arrays) {
        const std::string found = canonicalUnit(Dimension::Speed, array->unit);
        if (array != arrays.front() && found != unit)
            fail(array->name, expectedFound("the unit of the other components, " + unit, found));
        unit = found;
    }
    return unit;
}

} // namespace osgTreeWind
