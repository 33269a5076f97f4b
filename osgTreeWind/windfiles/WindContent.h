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

/// Result of the reader of one format: velocities in the file's unit along the axes of its own map (for
/// degrees: toward east and true north), NaN where there are no data, and the textual part of the summary.
struct WindContent {
    WindSummary summary;                           ///< Format, unit, coordinates and notes.
    std::variant<GridWind::Grid, WindSeries> data; ///< A grid, or a record at one place.
    std::vector<std::string> assumptions;          ///< Notes on assumptions and omitted data.
    std::optional<WindExtent> fileExtent;          ///< Extent of the file, if only a part was read.
    std::size_t missingCount = 0; ///< Number of velocities without data, which WindFile.cpp sets to 0.
    double travelSpeed = 0.0;     ///< Speed at which the grid drifts along x, m/s; 0 if it does not.

    /// The members that a reader process sends for a grid (Wire).
    auto parts() {
        auto& grid = std::get<GridWind::Grid>(data);
        return std::tie(summary.format, summary.unit, summary.direction, summary.coordinates, summary.crs,
                        summary.start, summary.notes, summary.mayIncludeTrees, grid.points, grid.origin,
                        grid.cell, grid.times, grid.heights, grid.aboveGround, grid.values, fileExtent);
    }
};

} // namespace osgTreeWind
