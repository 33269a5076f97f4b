// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/model/Skeleton.h>

namespace osgTreeWind {

/// The wood of a tree that has grown: its thickest axes as at most 250 units, all others as shoots, and the
/// stretches of both that bear leaves.
Skeleton makeSkeleton(const GrownForm& form);

} // namespace osgTreeWind
