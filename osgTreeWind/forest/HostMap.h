// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <glm/mat4x4.hpp>

namespace osgTreeWind {

/// Takes places of a forest's node, metres from its origin, to the map of its host (`hostCrs`). On another
/// map than the forest's own it is turned and scaled on the level as that map is at the origin, and heights
/// stay; away from the origin the two maps part as they bend: by millimetres in a kilometre between UTM
/// zones. A problem where the forest has no map, a map is not in metres, or the origin lies outside the
/// host's map.
OSGTREEWIND_EXPORT Result<glm::dmat4> placeOnHostMap(const ForestDescription& forest);

} // namespace osgTreeWind
