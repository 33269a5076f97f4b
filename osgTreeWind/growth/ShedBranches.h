// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Lets branches die whose leaves get too little light, breaks some, and drops old dead wood. Reads
/// Metamer::light and leafArea. Removes metamers and their buds, which changes the indices of the others.
void shedBranches(TreeState& tree);

} // namespace osgTreeWind
