// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Adds the bark of a skeleton's shoots to that of its units, after the vertices of the unit that bears them:
/// three-sided prisms that close to a point.
/// @param tolerance allowed error of their course, metres. @param thinnest smallest base radius, metres.
void addShootSkin(const Skeleton& skeleton, float tolerance, float thinnest, BranchSkin& skin);

/// Numbers of what addShootSkin() adds at full detail.
SkinSize sizeOfShootSkin(const Skeleton& skeleton);

} // namespace osgTreeWind
