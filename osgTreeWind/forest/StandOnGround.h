// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

/// Puts trees of a forest on its ground: each grows upright, its foot at the lowest point of the trunk's
/// circle. @param trees their indices. @return what check() finds, or an index of no tree, and nothing is
/// changed; one problem where some have no ground below them: how many, and which first; those stay where
/// they are. Empty when it is done, and for a forest without a ground.
OSGTREEWIND_EXPORT Diagnostics standOnGround(ForestDescription& forest,
                                             const std::vector<std::size_t>& trees);

} // namespace osgTreeWind
