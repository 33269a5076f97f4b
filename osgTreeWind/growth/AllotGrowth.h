// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Shares out a year's growth among the buds: what their light has gained goes down to the foot and comes
/// back by the rule of Borchert and Honda 1984, at each node so much to the axis and so much to its side
/// shoots. From Bud::light; to Bud::gain and share. A bud without apical control has a share of its own gain,
/// 0 to 1.
void allotGrowth(TreeState& tree);

} // namespace osgTreeWind
