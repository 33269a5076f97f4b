// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/wind/GridWind.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Turns velocities that count from true north to the y axis of their grid's map, unless they are wanted as
/// stored. @return a note that says by how much; nothing where the map does not hold all points.
std::optional<std::string> turnFromTrueNorth(GridWind::Grid& grid, const Crs& map, bool asStored);

} // namespace osgTreeWind
