// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class MapProgram;

/// Heights in cells of a raster, through GDAL: whatever it reads, a VRT of tiles, turned or on degrees. In
/// metres, whatever unit, scale and offset the file has. Read at once; a value.
class Raster {
public:
    static Result<Raster> open(const std::string& path);
    /// The same by a program that reads several.
    /// @param band name or number of the band of heights; empty: the only one, or the one that its name
    /// tells.
    static Result<Raster> open(const std::string& path, MapProgram& program, const std::string& band = {});

    const std::string& path() const { return _path; }
    /// What its places are in, where it says so.
    const std::optional<Crs>& crs() const { return _crs; }
    int columns() const { return _columns; }
    int rows() const { return _rows; }

    /// The place of a point of it, counted in cells from the outer corner of the first one.
    glm::dvec2 placeOf(const glm::dvec2& cell) const;
    /// Metres, bilinear between the centres of cells; the outermost ones hold to their outer edge. None
    /// beyond that, and where a cell that counts has no height. @param place in its own system.
    std::optional<double> height(const glm::dvec2& place) const;

private:
    std::string _path;
    std::optional<Crs> _crs;
    int _columns = 0, _rows = 0;
    std::array<double, 6> _toPlace{}, _toCell{}; ///< GDAL's geotransform, and its inverse.
    std::vector<float> _heights;                 ///< Row by row; NaN: a hole.
};

} // namespace osgTreeWind
