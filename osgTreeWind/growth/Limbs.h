// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Whether the trunk is high enough to divide into limbs: from TreeHabit::trunkTop in the open, higher in a
/// closed stand.
bool trunkDissolves(const TreeState& tree);

/// Ends the trunk and adds limbs at its last nodes, aimed so that the crown gets its width: lower limbs at
/// wider angles. Some of the youngest boughs become limbs, too. @param end terminal bud of the trunk.
void dissolveTrunk(TreeState& tree, const Bud& end);

} // namespace osgTreeWind
