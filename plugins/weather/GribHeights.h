// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GridWind.h>

namespace osgTreeWind {

/// Makes heights that a file gives for each point and time increase upward in each column, as GridWind needs
/// them. A level without height, or not above the one below it, comes 1 cm above that one.
///
/// Where heights count from the model's ground, levels below it, which a model only makes up, get the wind of
/// the lowest level above it; so do those without height.
/// @param grid with heights, NaN where there are none, and values for each point and time.
void settleHeights(GridWind::Grid& grid);

} // namespace osgTreeWind
