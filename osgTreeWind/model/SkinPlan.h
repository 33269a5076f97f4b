// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

#include <vector>

namespace osgTreeWind {

/// What the skin of a joined skeleton makes of a unit.
struct SkinPlan {
    int rings = 2, sides = 3;
    int taken = 2; ///< Rings at points of the skeleton, evenly, its ends among them; without foot and collar.
    bool fromEnd = false; ///< It springs from its parent's end.
    bool closed = false;  ///< By a vertex at its tip.
};

/// Of all units, as makeBranchSkin() says. Sides are those for the thickness of a branch, of joined skeletons
/// halved along an axis as it thins, so that rings of different units meet corner by corner; and joined ones
/// have rings more for a foot and for collars.
std::vector<SkinPlan> planSkin(const Skeleton& skeleton, float tolerance);

} // namespace osgTreeWind
