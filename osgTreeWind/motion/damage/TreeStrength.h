// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Moments at the foot of a trunk that a tree bears, N m; 0: not known.
///
/// A stem breaks at breast height, as ForestGALES has it (Gardiner et al. 2000): stems grow to bear alike all
/// along (Morgan and Cannell 1994), and how a drawn one tapers says nothing of where it would break.
struct TreeStrength {
    double uproot = 0.0;   ///< overturningMoment()
    double breaking = 0.0; ///< breakingMoment()

    TreeStrength() = default;
    TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species);
};

} // namespace osgTreeWind
