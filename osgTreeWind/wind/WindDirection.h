// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// What a wind direction means: where the air comes from (meteorology) or where it goes.
enum class DirectionSense { From, Toward };

/// A horizontal wind as people write it down.
struct WindReading {
    double speed = 0.0;     ///< m/s, not negative.
    double direction = 0.0; ///< Degrees clockwise from north (+y), east (+x) is 90.
};

/// The velocity of a reading, horizontal, m/s toward. Any direction in degrees; finite numbers expected.
/// 5 m/s from 270 is (5, 0, 0).
OSGTREEWIND_EXPORT glm::vec3 windVelocity(const WindReading& reading, DirectionSense sense);

/// The reading of a velocity's horizontal part, direction in [0, 360); 0 for calm.
OSGTREEWIND_EXPORT WindReading windReading(const glm::vec3& velocity, DirectionSense sense);

} // namespace osgTreeWind
