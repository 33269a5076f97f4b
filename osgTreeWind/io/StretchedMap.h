// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

namespace osgTreeWind {

/// The map of a scene at a place: `map`, or the UTM zone of the place where the scale of `map` differs from 1
/// by more than 1 %. A note tells of the zone.
Result<Crs> trueMapAt(const glm::dvec2& place, const Crs& map, ForestReading& reading);

/// Moves the forest from a map that trueMapAt() would leave to the one that it gives: the trees that were
/// read, and whatever is read later. Forests in tiles stay where they are.
void leaveStretchedMap(ForestReading& reading);

} // namespace osgTreeWind
