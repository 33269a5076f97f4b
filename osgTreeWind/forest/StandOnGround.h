// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

/// Sets the heights of trees so that they stand on the forest's ground, each with its foot at the lowest
/// ground within the circle of its trunk. Does nothing without a ground.
/// @param trees indices of the trees.
/// @return the problems. If check() fails or an index is invalid, nothing changes. If some trees have no
/// ground below them, one problem reports their number and the first of them, and they keep their height.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics standOnGround(ForestDescription& forest,
                                                           const std::vector<std::size_t>& trees);

} // namespace osgTreeWind
