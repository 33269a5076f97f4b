// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

namespace osgTreeWind {

/// A map in true metres for a scene at a place: `map` itself, or where its scale differs from 1 by more than
/// 1 % the UTM zone of the place, with a note.
Result<Crs> trueMapAt(const glm::dvec2& place, const Crs& map, ForestReading& reading);

/// Brings all trees that were read, and whatever is read from now on, to a map in true metres where that of
/// the forest is none. Forests in tiles stay where they are.
void leaveStretchedMap(ForestReading& reading);

} // namespace osgTreeWind
