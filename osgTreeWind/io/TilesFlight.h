// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestTiles.h>

#include <glm/vec3.hpp>

#include <string>

namespace osgTreeWind {

/// A flight over the tiles, for `osgviewer -p`: an ellipse about their middle, half as long and wide, at 50
/// m/s and above the trees, looking ahead and to the inside. A line each of time (s), place and rotation (x,
/// y, z, w) of the camera.
/// @param origin of the forest, in whose frame the places are.
std::string flightOver(const ForestTiles& tiles, const glm::dvec3& origin);

} // namespace osgTreeWind
