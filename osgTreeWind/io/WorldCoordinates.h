// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/Range.h>

namespace osgTreeWind {

/// World coordinates, metres: any map projection of the Earth.
constexpr Range worldCoordinates = within(-1e8, 1e8);

} // namespace osgTreeWind
