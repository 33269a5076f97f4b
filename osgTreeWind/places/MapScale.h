// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

namespace osgTreeWind {

/// The ratio of metres on a map to metres on the ground (WGS 84) at a place: east or north, whichever differs
/// more from 1. For example, 1.52 for web maps (EPSG:3857) in Paris. A ratio within 1 % of 1, as of a UTM
/// zone, is given as exactly 1, and so is that of a place where the map is undefined.
double scaleOfMap(const Crs& map, const glm::dvec2& place);

} // namespace osgTreeWind
