// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

namespace osgTreeWind {

/// The number of metres on `map` for one metre of the scene at a place: scaleOfMap(), or 1 if the file keeps
/// the scene on the map (`stretched = true`).
double mapMetresAt(const glm::dvec2& place, const Crs& map, const ForestReading& reading);

/// The map of a scene at a place: `map`, or the UTM zone of the place if mapMetresAt() is not 1. A note tells
/// of the zone.
Result<Crs> trueMapAt(const glm::dvec2& place, const Crs& map, ForestReading& reading);

/// Moves the forest from a map that trueMapAt() would leave to the one that it gives: the trees that were
/// read, and whatever is read later. Forests in tiles stay where they are.
void leaveStretchedMap(ForestReading& reading);

} // namespace osgTreeWind
