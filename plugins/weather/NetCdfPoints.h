// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfAxes.h>

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// The points and times of a file to be read.
struct NetCdfPoints {
    std::optional<NetCdfDimension> time, level;
    std::vector<std::size_t> times;  ///< Indices in the file; one if there is no time dimension.
    std::vector<std::size_t> levels; ///< Indices in the file, upward; one if there is no level dimension.
    std::vector<double> levelsAt;    ///< Coordinates of the levels.
    NetCdfAxis yAxis, xAxis;
    AxisPart y, x;             ///< The parts of the axes to be read.
    glm::dvec2 mapOffset{0.0}; ///< Added to x and y to get coordinates in the CRS.

    std::size_t perLevel() const { return y.indices.size() * x.indices.size(); }
    std::size_t perTime() const { return levels.size() * perLevel(); }
    std::size_t count() const { return times.size() * perTime(); }
};

/// Removes points of `part` beyond the ends of an axis whose points are midway between them.
void clipToAxis(const NetCdfAxis& other, const NetCdfAxis& axis, AxisPart& part);

/// Reads an array at the points, in the order time, level, row, column. If its axes are midway between those
/// of the points (staggered), neighbours are averaged. Fails for other axes, and for an array without levels
/// if the points have levels. An array without time, or without levels if `isFlat`, returns only one time or
/// level.
std::vector<float> readAtPoints(NetCdfFile& file, const NetCdfArray& array, const NetCdfPoints& points,
                                bool isFlat = false);

} // namespace osgTreeWind
