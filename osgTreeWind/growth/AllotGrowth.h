// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Distributes a year's growth among the buds. The gains of their light are summed towards the foot, and the
/// sum is divided at each node between the axis and its side shoots (Borchert and Honda 1984). Reads
/// Bud::light; sets Bud::gain and Bud::share. Without apical control a bud's share is its own gain, 0 to 1.
void allotGrowth(TreeState& tree);

} // namespace osgTreeWind
