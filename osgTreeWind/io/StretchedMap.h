// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

namespace osgTreeWind {

/// The number of metres on `map` for one metre of the scene at a place: scaleOfMap(), or 1 if the file keeps
/// the scene on the map (`stretched = true`).
double mapMetresAt(const glm::dvec2& place, const Crs& map, const ForestReading& reading);

/// The CRS for a scene at a place: `map`, or the UTM zone of the place if mapMetresAt() is not 1, with a
/// note.
Result<Crs> sceneMapAt(const glm::dvec2& place, const Crs& map, ForestReading& reading);

/// Reprojects the trees read so far to sceneMapAt() their centre, and sets `toScene` for what is read later.
/// Does not affect forests in tiles.
void reprojectStretchedMap(ForestReading& reading);

} // namespace osgTreeWind
