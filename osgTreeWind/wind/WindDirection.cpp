// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindDirection.h>

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {

glm::vec3 windVelocity(const WindReading& reading, DirectionSense sense) {
    const double bearing = reading.direction;
    const double speed = sense == DirectionSense::From ? -reading.speed : reading.speed;
    return {speed * std::sin(bearing), speed * std::cos(bearing), 0.0};
}

WindReading windReading(const glm::vec3& velocity, DirectionSense sense) {
    const double toward = sense == DirectionSense::Toward ? 1.0 : -1.0;
    const double east = velocity.x, north = velocity.y;
    WindReading reading;
    reading.speed = std::hypot(east, north);
    if (reading.speed > 0.0)
        reading.direction = std::atan2(toward * east, toward * north);
    if (reading.direction < 0.0)
        reading.direction += glm::two_pi<double>();
    if (reading.direction >= glm::two_pi<double>()) // a tiny negative angle rounds up to the full turn
        reading.direction = 0.0;
    return reading;
}

} // namespace osgTreeWind
