// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// The shoots of a year, from Bud::share: their length, direction, side buds and new ends.
/// @param foot of the tree in the grid.
void growShoots(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot);

} // namespace osgTreeWind
