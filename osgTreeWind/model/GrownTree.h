// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/GrownTreeParameters.h>
#include <osgTreeWind/model/Skeleton.h>

namespace osgTreeWind {

/// The parameters with every value brought into its range; NaN becomes the default. Twigs, then branches are
/// left out until the skeleton has at most maxSkeletonPoints.
GrownTreeParameters clamped(GrownTreeParameters parameters);

/// Grows a skeleton: a trunk (level 0) with boughs along it (1) that reach to the outline of the crown,
/// branches along these (2), twigs along those (3). Boughs hang at most a quarter of the crown's width below
/// its base, and not into the ground. Azimuths are uniform. Out-of-range parameters are clamped().
Skeleton makeGrownTree(const GrownTreeParameters& parameters);

} // namespace osgTreeWind
