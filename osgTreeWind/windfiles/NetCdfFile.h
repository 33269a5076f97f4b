// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A NetCDF file through GDAL's multidimensional interface. After the first problem every function gives
/// nothing more. Not part of the interface, and compiled with GDAL only.
class NetCdfFile {
public:
    using Array = std::shared_ptr<GDALMDArray>;
    using Dimension = std::shared_ptr<GDALDimension>;

    explicit NetCdfFile(const std::string& path);

    bool good() const { return _problem.message.empty(); }
    const Diagnostic& problem() const { return _problem; }
    /// Keeps a problem with an array, unless there is one already.
    void fail(const std::string& array, const std::string& message);

    /// The array of this name; null where there is none.
    Array array(const std::string& name) const;
    /// The first array that satisfies a condition; null where there is none.
    Array find(const std::function<bool(const Array&)>& condition) const;

    /// An attribute as text; empty where there is none.
    static std::string text(const Array& array, const char* attribute);
    /// A number that the file as a whole states; empty where it does not, or states none that is finite.
    std::optional<double> number(const char* attribute) const;
    /// The same for one that must be there, and above 0.
    double positive(const char* attribute);

    /// All numbers of an array, unpacked; NaN where there are no data. Refused where a file of this size
    /// cannot hold them, or they are not `count`.
    std::vector<float> read(const Array& array, double count);
    /// The coordinates of a dimension, in metres. Empty where the file has none.
    std::vector<double> metres(const Dimension& dimension);
    /// The seconds of an array of times since the first. @param start as much as the file says of the first.
    std::vector<double> seconds(const Array& times, std::string& start);
    /// The array of coordinates of a dimension; null where there is none.
    Array coordinates(const Dimension& dimension) const;
    /// The unit of speed that all these arrays have, empty when they have none.
    std::string speedUnitOf(const std::vector<Array>& arrays);

private:
    std::vector<double> readDoubles(const Array& array);

    std::unique_ptr<GDALDataset> _dataset;
    std::shared_ptr<GDALGroup> _root;
    double _bytes = 0.0;
    std::string _path;
    Diagnostic _problem;
};

/// The ways between a projection and the longitudes and latitudes of its globe, degrees.
struct Projection {
    std::unique_ptr<OGRCoordinateTransformation> toMap, toGlobe;

    /// Without `toMap` where the projection cannot say.
    explicit Projection(const OGRSpatialReference& projection);
};

/// Wind by CF names, or in arrays called u and v: on axes in metres. What counts from true north is turned to
/// the y axis of the file's projection, unless wanted as stored.
Result<WindContent> readNetCdfCf(NetCdfFile& file, bool asStored);
/// Output of the Weather Research and Forecasting model: destaggered, heights (PH + PHB) / 9.81, in metres of
/// the model's projection. Where the model's grid moves its winds are put in their places, unless wanted as
/// stored.
Result<WindContent> readNetCdfWrf(NetCdfFile& file, bool asStored);

} // namespace osgTreeWind
