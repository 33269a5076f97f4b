// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribField.h>

#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/windfiles/EvenAxis.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// CRS and axes of the points of a field.
struct GribGeoreference {
    Crs crs;
    std::string name; ///< PROJ text of the CRS; its name from GDAL is not specific.
    EvenAxis x, y;
};

/// Reads the georeference of fields with GDAL and their values with ecCodes. GDAL gets a message with zero
/// values, so that it does not have to support the packing.
class GribValues {
public:
    /// @param path of the file, for messages.
    explicit GribValues(std::string path) : _path(std::move(path)) {}

    /// Call before read() of fields on the same grid.
    Result<GribGeoreference> georeference(const GribField& field);
    /// Values at the points of both axes, x fastest; NaN if missing.
    Result<std::vector<float>> read(const GribField& field, const AxisPart& x, const AxisPart& y) const;

private:
    Diagnostic problem(const GribField& field, const std::string& message) const;

    std::string _path;
    GribGeoreference _georeference;
};

} // namespace osgTreeWind
