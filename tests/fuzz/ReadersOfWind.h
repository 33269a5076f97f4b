// SPDX-License-Identifier: MIT
#pragma once

#include <tests/fuzz/Readers.h>

#include <osgTreeWind/windfiles/WindContent.h>

namespace osgTreeWind {

/// Requires that the result is an error with a message, a grid with a value for each point, or a series with
/// a velocity for each time.
inline void requireValid(const Result<WindContent>& content) {
    if (!isRead(content))
        return;
    if (const auto* series = std::get_if<WindSeries>(&content.value().data))
        require(series->times.size() == series->velocities.size());
    if (const auto* grid = std::get_if<GridWind::Grid>(&content.value().data)) {
        const double steps = grid->times.empty() ? 1.0 : static_cast<double>(grid->times.size());
        require(3.0 * grid->points.x * grid->points.y * grid->points.z * steps ==
                static_cast<double>(grid->values.size()));
    }
}

} // namespace osgTreeWind
