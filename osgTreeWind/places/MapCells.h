// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec2.hpp>

#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// Numbers in square cells of a map, as speeds or directions of a wind.
struct MapCells {
    glm::ivec2 cells{0};
    glm::dvec2 south{0.0}; ///< Centre of the south-western cell.
    double cellSize = 1.0;
    std::vector<float> values; ///< South row first; NaN where there are no data.
    std::string crs;           ///< As Crs::text(); empty: not known.
    std::string unit;          ///< As the file says it; empty: it does not.

    auto parts() { return std::tie(cells, south, cellSize, values, crs, unit); } ///< For Wire.
};

/// Reads a GeoTIFF of one band, north up.
Result<MapCells> readGeoTiffCells(const std::string& path);

} // namespace osgTreeWind
