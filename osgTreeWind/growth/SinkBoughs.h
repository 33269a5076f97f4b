// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Boughs sink at their foot and bend under their weight, fast while young and ever slower; all that they
/// bear goes with them. Nothing sinks into the ground.
void sinkBoughs(TreeState& tree);

/// Places of all nodes from their headings and lengths.
void placeNodes(TreeState& tree);

} // namespace osgTreeWind
