// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Factor on the radius of a ring of so many sides that gives it the mean width of an octagon.
float ringWidening(int sides);

/// Bark coordinate at the base of a unit: bark goes on from where the branch springs.
/// @param skin of all units before it.
float barkStart(const BranchUnit& unit, const BranchSkin& skin);

/// Adds the triangles between rings of vertices, from a vertex on.
/// @param closed the last ring, by one more vertex after it.
void addRingTriangles(BranchSkin& skin, std::size_t firstVertex, int rings, int sides, bool closed);

/// Adds the triangles of the unit whose rings are the vertices since the last one, as addRingTriangles()
/// does.
void finishUnit(BranchSkin& skin, int rings, int sides, bool closed = false);

} // namespace osgTreeWind
