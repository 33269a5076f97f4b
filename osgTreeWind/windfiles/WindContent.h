// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <cstddef>
#include <optional>
#include <tuple>
#include <variant>

namespace osgTreeWind {

/// What the reader of one format hands over: velocities in the file's unit along the axes of its own map (on
/// degrees: toward east and true north), NaN where it has no data, and the textual part of the summary.
struct WindContent {
    WindSummary summary;                           ///< What it says of itself.
    std::variant<GridWind::Grid, WindSeries> data; ///< On a grid, or over time at one place.
    std::vector<std::string> assumed; ///< What had to be to read it, and what was left out: notes.
    std::optional<WindExtent> whole;  ///< Of the file, where only a part of it was read.
    std::size_t missing = 0;          ///< Velocities without data that were taken as calm.
    double travelSpeed = 0.0;         ///< m/s along x at which the whole grid drifts past; 0 where it stands.

    /// What passes of a grid from the process that reads it (Wire).
    auto parts() {
        auto& grid = std::get<GridWind::Grid>(data);
        return std::tie(summary.format, summary.unit, summary.direction, summary.coordinates, summary.crs,
                        summary.start, summary.notes, grid.points, grid.origin, grid.cell, grid.times,
                        grid.heights, grid.aboveGround, grid.values, whole);
    }
};

} // namespace osgTreeWind
