// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindDirection.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/gtc/constants.hpp>

namespace osgTreeWind {

glm::vec3 windVelocity(const WindReading& reading, DirectionSense sense) {
    const double bearing = reading.direction;
    const double speed = sense == DirectionSense::From ? -reading.speed : reading.speed;
    return {speed * math::sin(bearing), speed * math::cos(bearing), 0.0};
}

WindReading windReading(const glm::vec3& velocity, DirectionSense sense) {
    const double toward = sense == DirectionSense::Toward ? 1.0 : -1.0;
    const double east = velocity.x, north = velocity.y;
    WindReading reading;
    reading.speed = math::hypot(east, north);
    if (reading.speed > 0.0)
        reading.direction = math::atan2(toward * east, toward * north);
    if (reading.direction < 0.0)
        reading.direction += glm::two_pi<double>();
    if (reading.direction >= glm::two_pi<double>()) // a tiny negative angle rounds up to the full turn
        reading.direction = 0.0;
    return reading;
}

} // namespace osgTreeWind
