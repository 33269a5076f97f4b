// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribField.h>

#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/windfiles/EvenAxis.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// Where the points of a field lie.
struct GribPlace {
    Crs crs;
    std::string name; ///< Of the system, as PROJ writes it: GDAL gives all the same name.
    EvenAxis x, y;
};

/// Places of fields through GDAL, and their numbers through ecCodes. GDAL is given one message
/// without its numbers, so that it need not know how they are packed.
class GribNumbers {
public:
    /// @param path of the file that the fields are of.
    explicit GribNumbers(std::string path) : _path(std::move(path)) {}

    /// Before read() of fields on the same grid.
    Result<GribPlace> place(const GribField& field);
    /// Numbers at the points of both axes, x fastest; NaN where there are none.
    Result<std::vector<float>> read(const GribField& field, const AxisPart& x, const AxisPart& y) const;

private:
    Diagnostic problem(const GribField& field, const std::string& message) const;

    std::string _path;
    GribPlace _place;
};

} // namespace osgTreeWind
