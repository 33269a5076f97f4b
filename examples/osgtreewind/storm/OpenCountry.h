// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace osgTreeWind {

/// Wind profile over short grass, z0 = 3 cm (Wieringa 1993), relative to the wind at a height, metres.
LogProfile openCountryProfile(double height);

/// Gusty wind over short grass. The standard deviation along the wind is 2.4 u* (Panofsky and Dutton 1984).
/// @param height metres, at least 0.1. @param mean mean wind at that height, horizontal, m/s, at most 200.
Wind openCountryWind(double height, const glm::vec3& mean, std::uint32_t seed);

} // namespace osgTreeWind
