// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GridWind.h>

namespace osgTreeWind {

/// Makes heights increase upward in each column, as GridWind requires. A level that has no height, or is not
/// above the previous one, is placed 1 cm above it.
///
/// If heights are above ground, levels below the ground (extrapolated by the model) or without a height get
/// the wind of the lowest level above the ground.
/// @param grid with heights (NaN if missing) and values for each point and time.
void makeHeightsIncrease(GridWind::Grid& grid);

} // namespace osgTreeWind
