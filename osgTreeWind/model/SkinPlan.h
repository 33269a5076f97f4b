// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

#include <vector>

namespace osgTreeWind {

/// Rings and sides of the skin of one unit.
struct SkinPlan {
    int rings = 2, sides = 3;
    int skeletonRings = 2; ///< Rings at points of the skeleton, evenly spaced; without foot and collar.
    bool fromEnd = false;  ///< Whether the unit springs from its parent's end.
    bool closed = false;   ///< Whether a vertex closes the tip.
};

/// Plans the skin of all units, see makeBranchSkin(). The number of sides follows from the thickness of a
/// branch; in a joined skeleton it is halved along an axis as that thins, so that the rings of successive
/// units share corners.
std::vector<SkinPlan> planSkin(const Skeleton& skeleton, float tolerance);

} // namespace osgTreeWind
