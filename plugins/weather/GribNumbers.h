// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribField.h>

#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/windfiles/EvenAxis.h>

#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Where the points of a field lie.
struct GribPlace {
    Crs crs;
    std::string name; ///< Of the system, as PROJ writes it: GDAL gives all the same name.
    EvenAxis x, y;
};

/// Numbers and places of fields through GDAL, which is given one message at a time: one that lies on another
/// grid, or that GDAL cannot read, does not disturb the others, and nothing is read that is not asked for.
class GribNumbers {
public:
    /// @param path of the file that the fields are of.
    explicit GribNumbers(std::string path);

    Result<GribPlace> place(const GribField& field);
    /// Numbers at the points of both axes, x fastest; NaN where there are none.
    /// @param units that they may have, as GDAL writes them.
    Result<std::vector<float>> read(const GribField& field, const AxisPart& x, const AxisPart& y,
                                    const std::vector<std::string>& units);

private:
    /// The dataset of its message, with that many bands; null: a problem was kept.
    void* open(const GribField& field);
    Diagnostic problem(const GribField& field, const std::string& message) const;

    std::string _path, _reason, _warning;
    std::size_t _begin = 0;
    std::shared_ptr<void> _data;
};

} // namespace osgTreeWind
