// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

constexpr float airDensity = 1.225f; ///< kg/m^3, standard atmosphere at sea level.
constexpr double gravity = 9.81;     ///< m/s^2

} // namespace osgTreeWind
