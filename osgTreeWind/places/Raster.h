// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class MapProgram;

/// Heights of a raster file in metres, after its unit, scale and offset are applied. It may have any GDAL
/// format, be a VRT of tiles, and be rotated or in degrees. The whole raster is in memory. A value type.
class Raster {
public:
    static Result<Raster> open(const std::string& path);
    /// Reads with a program that is shared by several rasters.
    /// @param band name or number of the band with heights; empty: the only band, or chosen by its name.
    static Result<Raster> open(const std::string& path, MapProgram& program, const std::string& band = {});

    const std::string& path() const { return _path; }
    /// As stated by the file.
    const std::optional<Crs>& crs() const { return _crs; }
    int columns() const { return _columns; }
    int rows() const { return _rows; }

    /// Transforms raster coordinates, in cells from the outer corner of the first cell, to the raster's CRS.
    glm::dvec2 placeOf(const glm::dvec2& cell) const;
    /// Height in metres, bilinear between cell centres and constant in the outer half of border cells. Empty
    /// outside the raster, and if a contributing cell has no height. @param place in the raster's CRS.
    std::optional<double> height(const glm::dvec2& place) const;

private:
    std::string _path;
    std::optional<Crs> _crs;
    int _columns = 0, _rows = 0;
    std::array<double, 6> _geotransform{}, _inverseGeotransform{}; ///< As defined by GDAL.
    std::vector<float> _heights;                                   ///< Row by row; NaN: no data.
};

} // namespace osgTreeWind
