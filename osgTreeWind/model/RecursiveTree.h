// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeParameters.h>

#include <cstdint>

namespace osgTreeWind {

/// The largest angle of a branch from the vertical: somewhat below the horizontal.
constexpr float maxInclination = 2.17f;

/// The most points a skeleton may have: 65,536 units of 16 rings, some 0.5 GB of skin.
constexpr std::uint64_t maxSkeletonPoints = 1u << 20;

/// The parameters with every value brought into its range; NaN becomes the default. `levels` is lowered
/// until the skeleton has at most maxSkeletonPoints.
RecursiveTreeParameters clamped(RecursiveTreeParameters parameters);

/// Trunk units that bear branches at their ends: 1 for the thesis' tree, more for a conifer.
/// @param parameters clamped() ones.
int branchingUnits(const RecursiveTreeParameters& parameters);

/// Grows a skeleton. Out-of-range parameters are clamped(). Branches shorter than 1e-4 and radii thinner than
/// 1e-5 of the tree's reach are brought up to that, so that no part of it degenerates.
Skeleton makeRecursiveTree(const RecursiveTreeParameters& parameters);

} // namespace osgTreeWind
