// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Branches whose leaves do not get the light they need die, and some break; dead wood falls after its time.
/// From Metamer::light and leafArea; takes away metamers, their buds, and moves the others up.
void shedBranches(TreeState& tree);

} // namespace osgTreeWind
