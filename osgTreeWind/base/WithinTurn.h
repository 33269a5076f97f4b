// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {

/// The same direction within a turn either way, as files have it. @param angle radians, finite.
inline float withinTurn(float angle) {
    constexpr auto turn = glm::two_pi<double>();
    return std::abs(static_cast<double>(angle)) > turn
               ? static_cast<float>(std::remainder(static_cast<double>(angle), turn))
               : angle;
}

} // namespace osgTreeWind
