// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Grows the shoots of a year from Bud::share: sets their length and direction, and adds their side buds and
/// terminal buds. @param foot position of the tree in the grid.
void growShoots(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot);

} // namespace osgTreeWind
