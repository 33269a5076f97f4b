// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Resistive moments of a tree at the foot of its trunk, N m; 0: unknown.
///
/// Stems grow to be equally strong all along (Morgan and Cannell 1994), and the taper of a drawn stem does
/// not tell where it would break. So the stem is assessed at breast height, where the moment of a wind that
/// acts in the middle of the crown is smaller than at the foot, as in ForestGALES (Gardiner et al. 2000; Hale
/// et al. 2015).
struct TreeStrength {
    double uproot = 0.0;   ///< overturningMoment()
    double breaking = 0.0; ///< breakingMoment() at breast height, converted to the foot.

    double limit() const; ///< The smaller of the two that are known; 0: none.

    TreeStrength() = default;
    TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species);
};

} // namespace osgTreeWind
