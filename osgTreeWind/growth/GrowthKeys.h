// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/growth/GrowthParameters.h>

namespace osgTreeWind {

/// Keys of [species.habit] in files: the size, the habit, the flare and the seed. The site is not in files;
/// it follows from the place of the tree.
template <>
const Keys& keysOf<GrowthParameters>();

} // namespace osgTreeWind
