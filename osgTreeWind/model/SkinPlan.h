// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

#include <vector>

namespace osgTreeWind {

/// What the skin of a joined skeleton makes of a unit.
struct SkinPlan {
    int rings = 2, sides = 3;
    bool fromEnd = false; ///< It springs from its parent's end.
    bool closed = false;  ///< By a vertex at its tip.
};

/// Of all units. Whole skins have sides for the thickness of a branch, halved along an axis as it thins, so
/// that rings of different units meet corner by corner; and rings more for a foot and for collars.
/// @param detail within its ranges.
std::vector<SkinPlan> planSkin(const Skeleton& skeleton, const SkinDetail& detail);

} // namespace osgTreeWind
