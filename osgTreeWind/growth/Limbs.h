// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Whether the trunk now dissolves into limbs: at TreeHabit::trunkTop where light comes from the sides, later
/// in a closed wood.
bool trunkDissolves(const TreeState& tree);

/// Ends the trunk. Limbs spring from its last nodes and aim at the width of the crown, the lower the wider;
/// the youngest boughs become limbs, too. @param end bud at the end of the trunk.
void dissolveTrunk(TreeState& tree, const Bud& end);

} // namespace osgTreeWind
