// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/windfiles/WindContent.h>

namespace osgTreeWind {

/// Has Wire pass a grid from the process that reads it.
inline bool passMembers(Wire& wire, WindContent& content) {
    WindSummary& summary = content.summary;
    auto& grid = std::get<GridWind::Grid>(content.data);
    unsigned char aboveGround = grid.aboveGround ? 1 : 0;
    const bool good = wire.pass(summary.format, summary.unit, summary.direction, summary.coordinates,
                                summary.crs, summary.start, summary.notes, grid.points, grid.origin,
                                grid.cell, grid.times, grid.heights, aboveGround, grid.values);
    grid.aboveGround = aboveGround != 0;
    return good;
}

} // namespace osgTreeWind
