// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeParameters.h>

#include <cstdint>

namespace osgTreeWind {

/// The largest angle of a branch from the vertical, radians: somewhat below the horizontal.
constexpr float maxInclination = 2.17f;

/// The maximum number of points of a skeleton: 65,536 units of 16 rings, about 0.5 GB of skin.
constexpr std::uint64_t maxSkeletonPoints = 1u << 20;

/// Clamps every value to its range; NaN becomes the default. `levels` is lowered until the skeleton has at
/// most maxSkeletonPoints.
RecursiveTreeParameters clamped(RecursiveTreeParameters parameters);

/// Number of trunk units that bear branches at their ends: 1 for the thesis' tree, more for a conifer.
/// @param parameters must be clamped().
int branchingUnits(const RecursiveTreeParameters& parameters);

/// Grows a skeleton. Parameters are clamped(). Branches are at least 1e-4 and radii at least 1e-5 of the
/// tree's reach, so that no part degenerates.
Skeleton makeRecursiveTree(const RecursiveTreeParameters& parameters);

} // namespace osgTreeWind
