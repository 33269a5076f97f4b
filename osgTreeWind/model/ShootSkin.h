// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Adds the bark of a skeleton's shoots to that of its units, behind the vertices of the unit that bears
/// them: prisms of three sides that close to a point.
/// @param tolerance metres, by which their course may be off. @param thinnest radius at the base below which
/// shoots are left out, metres.
void addShootSkin(const Skeleton& skeleton, float tolerance, float thinnest, BranchSkin& skin);

/// Numbers of what addShootSkin() adds with a tolerance and a radius of 0.
SkinSize sizeOfShootSkin(const Skeleton& skeleton);

} // namespace osgTreeWind
