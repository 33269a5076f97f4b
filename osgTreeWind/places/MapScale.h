// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <optional>

namespace osgTreeWind {

/// Metres of a map for one on the ground (WGS 84), at a place of it: east or north, whichever is farther
/// from 1. 1.52 for web maps (EPSG:3857) in Paris, within 0.001 of 1 in a UTM zone. Empty where the map has
/// no such place.
std::optional<double> scaleOfMap(const Crs& map, const glm::dvec2& place);

/// Whether a scale differs from 1 by more than 1 %, so that trees on this map would stand too far apart.
inline bool isStretched(double scale) {
    return scale < 0.99 || scale > 1.01;
}

} // namespace osgTreeWind
