// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/model/Skeleton.h>

namespace osgTreeWind {

/// The wood of a grown tree: the thickest axes as at most 250 units and the others as shoots, with leafy
/// parts.
Skeleton makeSkeleton(const GrownForm& form);

} // namespace osgTreeWind
