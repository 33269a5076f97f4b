// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace osgTreeWind {

/// Of the wind over short grass, z0 3 cm (Wieringa 1993), by that at a height, metres.
LogProfile openCountry(double height);

/// Gusts over it: the deviation along the wind is 2.4 u* (Panofsky and Dutton 1984).
/// @param mean at that height (metres, from 0.1 on), horizontal, m/s, at most 200.
WindFieldPtr openCountryWind(double height, const glm::vec3& mean, std::uint32_t seed);

} // namespace osgTreeWind
