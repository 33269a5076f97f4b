// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/wind/GridWind.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Turns velocities from true north to the y axis of their grid's CRS, unless `asStored` is set.
/// @return a note with the angles; empty if the CRS does not cover all points.
std::optional<std::string> turnFromTrueNorth(GridWind::Grid& grid, const Crs& map, bool asStored);

} // namespace osgTreeWind
