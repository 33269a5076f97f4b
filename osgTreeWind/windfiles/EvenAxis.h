// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Evenly spaced points along one direction of a grid, in the order of the file.
struct EvenAxis {
    double first = 0.0;
    double step = 1.0; ///< To the next; not 0, below 0 where the file counts down.
    std::size_t count = 1;
    double period = 0.0; ///< 360 for longitudes; 0: it does not come back to where it began.
};

/// Whether it comes back to its first point a step after its last one.
bool isRound(const EvenAxis& axis);

/// Points of an axis, upward.
struct AxisPart {
    double first = 0.0;
    double step = 1.0;                ///< Above 0.
    std::vector<std::size_t> indices; ///< Of each point in the file: one or two runs.
};

/// All of them, each once.
AxisPart wholeOf(const EvenAxis& axis);
/// Those between two coordinates and one more on either side, as far as the axis goes; across its seam where
/// it goes all the way round, then at most each once. The three nearest to the two where it does not reach
/// them.
AxisPart partAround(const EvenAxis& axis, double low, double high);

} // namespace osgTreeWind
