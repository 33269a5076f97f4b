// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfSelection.h>

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindRequest.h>

#include <gdal.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace osgTreeWind {

/// One dimension of an array.
struct NetCdfDimension {
    std::string name;
    std::size_t size = 0;
    bool temporal = false;
    std::string coordinates; ///< Name of the array of its coordinates, which need not be there.
};

/// An array and what the file says of it; its numbers are read by NetCdfFile.
struct NetCdfArray {
    using Attribute = std::unique_ptr<std::remove_pointer_t<GDALAttributeH>, decltype(&GDALAttributeRelease)>;

    std::unique_ptr<std::remove_pointer_t<GDALMDArrayH>, decltype(&GDALMDArrayRelease)> handle;
    std::string name, unit;
    std::vector<NetCdfDimension> dimensions;

    /// Null where there is none.
    Attribute attribute(const char* name) const;
    /// The same as text; empty where there is none.
    std::string text(const char* name) const;
    /// The same as a number; nothing where there is none.
    std::optional<double> number(const char* name) const;
    /// What its grid_mapping is, in metres where it is a map.
    std::optional<Crs> crs() const;
    bool is32BitFloat() const;
};

/// A NetCDF file through GDAL's multidimensional interface. After the first problem every function gives
/// nothing more.
class NetCdfFile {
public:
    using Array = std::shared_ptr<const NetCdfArray>;

    /// @param also a second file, whose arrays come behind those of the first; empty: none.
    explicit NetCdfFile(const std::string& path, const std::string& also = {});

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; }
    /// Keeps a problem with an array, unless there is one already.
    void fail(const std::string& array, const std::string& message);

    /// The array of this name; null where there is none.
    Array array(const std::string& name) const;
    const std::vector<Array>& arrays() const { return _arrays; }
    /// The first array that satisfies a condition; null where there is none.
    Array find(const std::function<bool(const NetCdfArray&)>& condition) const;

    /// A number that the file as a whole states; empty where it does not, or states none that is finite.
    std::optional<double> number(const char* name) const;
    /// The same for one that must be there, and above 0.
    double positive(const char* name);
    /// A text that the file as a whole states; empty where it does not.
    std::string text(const char* name) const;

    /// Numbers of an array, unpacked, in the order of the selection; NaN where there are no data. Refused
    /// where a file of this size cannot hold them.
    std::vector<float> read(const NetCdfArray& array, const NetCdfSelection& selection);
    /// All numbers of an array of one dimension, or of none; each finite.
    std::vector<double> coordinates(const NetCdfArray& array);
    /// The unit of speed that all these arrays have, empty when they have none.
    std::string speedUnitOf(const std::vector<Array>& arrays);

private:
    NetCdfArray::Attribute attribute(const char* name) const;
    bool holds(const NetCdfArray& array, const NetCdfSelection& selection);
    void unpack(const NetCdfArray& array, std::vector<float>& numbers) const;

    using Dataset = std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, decltype(&GDALReleaseDataset)>;
    using Group = std::unique_ptr<std::remove_pointer_t<GDALGroupH>, decltype(&GDALGroupRelease)>;

    /// The arrays of a file are kept. @return its root; null where it cannot be read.
    Group open(const std::string& path);

    std::vector<Dataset> _datasets;
    Group _root; ///< Of the first file.
    std::vector<Array> _arrays;
    double _bytes = 0.0;
    bool _isClassic = false;
    std::string _path;
    Diagnostic _problem;
};

/// Whether the file is output of the Weather Research and Forecasting model.
bool isWrf(const NetCdfFile& file);

/// Wind by CF names, or in arrays called u and v, as u10 and v10: on axes in metres or on degrees. What
/// counts from true north is turned to the y axis of the file's map, unless wanted as stored.
Result<WindContent> readNetCdfCf(NetCdfFile& file, const WindRequest& request);
/// Output of WRF: destaggered, heights (PH + PHB) / 9.81 less the model's ground, in metres of the model's
/// map. Where the model's grid moves its winds are put in their places, unless wanted as stored.
Result<WindContent> readNetCdfWrf(NetCdfFile& file, const WindRequest& request);

} // namespace osgTreeWind
