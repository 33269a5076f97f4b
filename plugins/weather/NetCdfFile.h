// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/Projection.h>

#include <osgTreeWind/base/Result.h>
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
    std::unique_ptr<std::remove_pointer_t<GDALMDArrayH>, decltype(&GDALMDArrayRelease)> handle;
    std::string name, unit;
    std::vector<NetCdfDimension> dimensions;

    /// An attribute as text; empty where there is none.
    std::string text(const char* attribute) const;
    std::optional<Projection> projection() const;
};

/// A NetCDF file through GDAL's multidimensional interface. After the first problem every function gives
/// nothing more.
class NetCdfFile {
public:
    using Array = std::shared_ptr<const NetCdfArray>;

    explicit NetCdfFile(const std::string& path);

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; }
    /// Keeps a problem with an array, unless there is one already.
    void fail(const std::string& array, const std::string& message);

    /// The array of this name; null where there is none.
    Array array(const std::string& name) const;
    /// The first array that satisfies a condition; null where there is none.
    Array find(const std::function<bool(const NetCdfArray&)>& condition) const;

    /// A number that the file as a whole states; empty where it does not, or states none that is finite.
    std::optional<double> number(const char* attribute) const;
    /// The same for one that must be there, and above 0.
    double positive(const char* attribute);

    /// All numbers of an array, unpacked; NaN where there are no data. Refused where a file of this size
    /// cannot hold them, or they are not `count`.
    std::vector<float> read(const NetCdfArray& array, double count);
    /// The coordinates of a dimension, in metres. Empty where the file has none.
    std::vector<double> metres(const NetCdfDimension& dimension);
    /// The seconds of an array of times since the first. @param start as much as the file says of the first.
    std::vector<double> seconds(const NetCdfArray& times, std::string& start);
    /// The unit of speed that all these arrays have, empty when they have none.
    std::string speedUnitOf(const std::vector<Array>& arrays);

private:
    std::vector<double> readDoubles(const NetCdfArray& array);

    std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, decltype(&GDALReleaseDataset)> _dataset;
    std::unique_ptr<std::remove_pointer_t<GDALGroupH>, decltype(&GDALGroupRelease)> _root;
    double _bytes = 0.0;
    std::string _path;
    Diagnostic _problem;
};

/// Wind by CF names, or in arrays called u and v: on axes in metres. What counts from true north is turned to
/// the y axis of the file's projection, unless wanted as stored.
Result<WindContent> readNetCdfCf(NetCdfFile& file, const WindRequest& request);
/// Output of the Weather Research and Forecasting model: destaggered, heights (PH + PHB) / 9.81, in metres of
/// the model's projection. Where the model's grid moves its winds are put in their places, unless wanted as
/// stored.
Result<WindContent> readNetCdfWrf(NetCdfFile& file, const WindRequest& request);

} // namespace osgTreeWind
