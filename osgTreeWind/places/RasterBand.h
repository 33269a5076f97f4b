// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec2.hpp>

#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// One band of a raster with square cells, such as wind speeds or directions.
struct RasterBand {
    glm::ivec2 cells{0};       ///< Number of columns and rows.
    glm::dvec2 southWest{0.0}; ///< Centre of the south-western cell.
    double cellSize = 1.0;
    std::vector<float> values; ///< South row first; NaN: no data.
    std::string crs;           ///< Crs::text(); empty if unknown.
    std::string unit;          ///< As stated by the file; may be empty.

    auto parts() { return std::tie(cells, southWest, cellSize, values, crs, unit); } ///< For Wire.
};

/// Reads a north-up GeoTIFF with one band.
Result<RasterBand> readGeoTiffBand(const std::string& path);

} // namespace osgTreeWind
