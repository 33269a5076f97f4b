// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// The way true north lies at points of a map: unit vectors along its x and y. Empty where it cannot say.
/// @param map in metres, or on degrees. @param points on it.
std::vector<glm::dvec2> trueNorth(const Crs& map, std::vector<glm::dvec2> points);

} // namespace osgTreeWind
