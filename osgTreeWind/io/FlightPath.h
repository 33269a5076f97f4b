// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestTiles.h>

#include <glm/vec3.hpp>

#include <string>

namespace osgTreeWind {

/// A camera path for `osgviewer -p`: an ellipse around the centre of the tiles, half as long and wide as they
/// are, at 50 m/s above the trees, looking ahead and inward. Each line has the time (s), position and
/// rotation (x, y, z, w) of the camera. @param origin of the forest, to which positions are relative.
std::string makeFlightPath(const ForestTiles& tiles, const glm::dvec3& origin);

} // namespace osgTreeWind
