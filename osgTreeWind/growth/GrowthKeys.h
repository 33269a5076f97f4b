// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/growth/GrowthParameters.h>

namespace osgTreeWind {

/// Keys of [species.habit] in files: of the size, the habit, the flare and the seed. The site has none: it
/// follows from the tree's place.
template <>
const Keys& keysOf<GrowthParameters>();

} // namespace osgTreeWind
