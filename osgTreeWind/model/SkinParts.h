// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Factor on the radius of a ring that gives it the mean width of an octagon.
float ringWidening(int sides);

/// Bark coordinate v at the base of a unit, continued from its parent. @param skin of all previous units.
float barkStart(const BranchUnit& unit, const BranchSkin& skin);

/// Adds the triangles between rings of vertices. @param closed whether one more vertex closes the end.
void addRingTriangles(BranchSkin& skin, std::size_t firstVertex, int rings, int sides, bool closed);

/// Ends a unit: adds its triangles as addRingTriangles() does, for all vertices since the last unit.
void finishUnit(BranchSkin& skin, int rings, int sides, bool closed = false);

} // namespace osgTreeWind
