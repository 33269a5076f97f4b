// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Moments at the foot of a trunk that a tree bears, N m; 0: not known.
///
/// Stems grow to bear alike all along (Morgan and Cannell 1994), and how a drawn one tapers says nothing of
/// where it would break. So what one bears is told by breast height, at which the moment is the less the
/// lower the wind pushes, in the middle of the crown, as ForestGALES has it (Gardiner et al. 2000; Hale et
/// al. 2015).
struct TreeStrength {
    double uproot = 0.0;   ///< overturningMoment()
    double breaking = 0.0; ///< breakingMoment() at breast height, brought down to the foot.

    TreeStrength() = default;
    TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species);
};

} // namespace osgTreeWind
