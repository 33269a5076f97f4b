// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Sinks boughs at their base and bends them under their weight, together with the wood that they bear.
/// Young wood sinks fastest. Boughs stay above the ground.
void sinkBoughs(TreeState& tree);

/// Computes the positions of all nodes from their headings and lengths.
void placeNodes(TreeState& tree);

} // namespace osgTreeWind
