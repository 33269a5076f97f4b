// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/Range.h>

namespace osgTreeWind {

/// What a tree may measure, metres; the tallest known tree stands 116 m.
constexpr Range treeHeights = above(0, 150);
constexpr Range trunkDiameters = above(0, 20);
constexpr Range crownWidths = above(0, 150);

} // namespace osgTreeWind
