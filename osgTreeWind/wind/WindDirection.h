// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Whether a direction is where the wind comes from (as in meteorology) or blows toward.
enum class DirectionSense { From, Toward };

/// A horizontal wind as speed and direction.
struct WindReading {
    double speed = 0.0;     ///< m/s, not negative.
    double direction = 0.0; ///< Radians clockwise from north (+y); east (+x) is pi/2.
};

/// Horizontal velocity of a reading, m/s toward: 5 m/s from the west, 3 pi/2, is (5, 0, 0). @param reading
/// finite numbers.
OSGTREEWIND_EXPORT glm::vec3 windVelocity(const WindReading& reading, DirectionSense sense);

/// Speed and direction, in [0, 2 pi), of the horizontal part of a velocity; both 0 if calm.
OSGTREEWIND_EXPORT WindReading windReading(const glm::vec3& velocity, DirectionSense sense);

} // namespace osgTreeWind
