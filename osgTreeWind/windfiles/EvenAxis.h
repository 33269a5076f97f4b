// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Evenly spaced coordinates along one dimension of a grid, in the order of the file.
struct EvenAxis {
    double first = 0.0;
    double step = 1.0; ///< Not 0; negative if the file is in descending order.
    std::size_t count = 1;
    double period = 0.0; ///< 360 for longitudes; 0 if the axis is not periodic.
};

/// Whether the axis covers a whole period: one step after the last point is the first point again.
bool isCyclic(const EvenAxis& axis);

/// Some points of an axis in ascending order.
struct AxisPart {
    double first = 0.0;
    double step = 1.0;                ///< Above 0.
    std::vector<std::size_t> indices; ///< Index of each point in the file; one or two consecutive runs.
};

/// All points of an axis, each once.
AxisPart wholeAxis(const EvenAxis& axis);
/// The points from `low` to `high` and one more on either side, clipped to the axis. Continues across the
/// seam of a cyclic axis, with each point at most once. Outside the axis: its three nearest points.
AxisPart partAround(const EvenAxis& axis, double low, double high);

} // namespace osgTreeWind
