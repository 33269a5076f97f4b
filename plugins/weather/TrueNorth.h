// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace osgTreeWind {

/// The way true north lies at points of a map: unit vectors along its x and y. Empty where the map has no way
/// to longitudes and latitudes, or does not hold all points. @param points in the unit of the map.
std::vector<glm::dvec2> trueNorth(const Crs& map, const std::vector<glm::dvec2>& points);

/// "-15.75 to 15.75 degrees clockwise": how far true north lies to the right of the y axis, least and most.
std::string rangeOfNorths(const std::vector<glm::dvec2>& norths);

} // namespace osgTreeWind
