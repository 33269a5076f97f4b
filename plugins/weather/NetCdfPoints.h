// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfAxes.h>

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The points and times of a file at which wind is wanted.
struct NetCdfPoints {
    std::optional<NetCdfDimension> time, level;
    std::vector<std::size_t> times;  ///< Indices in the file; one where there is no such dimension.
    std::vector<std::size_t> levels; ///< The same, upward.
    std::vector<double> levelsAt;    ///< Their coordinates.
    NetCdfAxis yAxis, xAxis;
    AxisPart y, x;         ///< Of them.
    glm::dvec2 onMap{0.0}; ///< Added to x and y it makes them those of the file's map.

    std::size_t perLevel() const { return y.indices.size() * x.indices.size(); }
    std::size_t perTime() const { return levels.size() * perLevel(); }
    std::size_t count() const { return times.size() * perTime(); }
};

/// Leaves out points that an axis midway between theirs does not reach.
void keepWithin(const NetCdfAxis& other, const NetCdfAxis& axis, AxisPart& part);

/// Numbers of an array at the points: by time, level, row and column. Where its axes lie midway between those
/// of the points they are means of the neighbours; any other axes are refused, and so is an array without
/// levels where points have some. One of no time, or of no level where `flat`, holds for all: it gives the
/// numbers of one.
std::vector<float> numbersAt(NetCdfFile& file, const NetCdfArray& array, const NetCdfPoints& points,
                             bool flat = false);

} // namespace osgTreeWind
