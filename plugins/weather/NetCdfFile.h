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

/// A dimension of an array.
struct NetCdfDimension {
    std::string name;
    std::size_t size = 0;
    bool isTime = false;
    std::string coordinates; ///< Name of its coordinate array, which may not exist.
};

/// An array with its attributes; NetCdfFile reads its numbers.
struct NetCdfArray {
    using Attribute = std::unique_ptr<std::remove_pointer_t<GDALAttributeH>, decltype(&GDALAttributeRelease)>;

    std::unique_ptr<std::remove_pointer_t<GDALMDArrayH>, decltype(&GDALMDArrayRelease)> handle;
    std::string name, unit;
    std::vector<NetCdfDimension> dimensions;

    /// Null if there is none.
    Attribute attribute(const char* name) const;
    /// An attribute as text; empty if there is none.
    std::string text(const char* name) const;
    /// An attribute as a number; empty if there is none.
    std::optional<double> number(const char* name) const;
    /// The CRS of its grid_mapping; projections are in metres.
    std::optional<Crs> crs() const;
    bool is32BitFloat() const;
};

/// A NetCDF file read by GDAL. Keeps the first problem, after which functions return nothing.
class NetCdfFile {
public:
    using Array = std::shared_ptr<const NetCdfArray>;

    /// @param secondFile its arrays follow those of the first; empty if there is none.
    explicit NetCdfFile(const std::string& path, const std::string& secondFile = {});

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; }
    /// Records a problem with an array, unless there is one already.
    void fail(const std::string& array, const std::string& message);

    /// The array with this name; null if there is none.
    Array array(const std::string& name) const;
    const std::vector<Array>& arrays() const { return _arrays; }
    /// The first array that satisfies a condition; null if there is none.
    Array find(const std::function<bool(const NetCdfArray&)>& condition) const;

    /// A global attribute as a number; empty if there is none or it is not finite.
    std::optional<double> number(const char* name) const;
    /// A required global attribute, above 0 and below 1e9; otherwise 1, with a problem.
    double positiveNumber(const char* name);
    /// A global attribute as text; empty if there is none.
    std::string text(const char* name) const;

    /// Reads and unpacks numbers of an array in the order of the selection; NaN if missing. Fails if a file
    /// of this size cannot contain them.
    std::vector<float> read(const NetCdfArray& array, const NetCdfSelection& selection);
    /// Reads all numbers of an array of at most one dimension. Fails if one is not finite.
    std::vector<double> coordinates(const NetCdfArray& array);
    /// The common unit of speed of these arrays; empty if they have none.
    std::string speedUnitOf(const std::vector<Array>& arrays);

private:
    NetCdfArray::Attribute attribute(const char* name) const;
    bool canHold(const NetCdfArray& array, const NetCdfSelection& selection);
    void unpack(const NetCdfArray& array, std::vector<float>& numbers) const;

    using Dataset = std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, decltype(&GDALReleaseDataset)>;
    using Group = std::unique_ptr<std::remove_pointer_t<GDALGroupH>, decltype(&GDALGroupRelease)>;

    /// Opens a file and adds its arrays. @return its root; null if it cannot be read.
    Group open(const std::string& path);

    std::vector<Dataset> _datasets;
    Group _root; ///< Root of the first file.
    std::vector<Array> _arrays;
    double _bytes = 0.0;
    bool _isClassic = false;
    std::string _path;
    Diagnostic _problem;
};

/// Whether the file is output of the Weather Research and Forecasting model.
bool isWrf(const NetCdfFile& file);

/// Reads wind by CF standard names, or from arrays with names such as u and v or u10 and v10, on axes in
/// metres or degrees. Velocities relative to true north are turned to the y axis of the projection, unless
/// WindRequest::asStored is set.
Result<WindContent> readNetCdfCf(NetCdfFile& file, const WindRequest& request);
/// Reads WRF output: destaggered, with heights (PH + PHB) / 9.81 minus the terrain, in metres of the model's
/// projection. Winds of a moving grid are placed where they blew, unless WindRequest::asStored is set.
Result<WindContent> readNetCdfWrf(NetCdfFile& file, const WindRequest& request);

} // namespace osgTreeWind
