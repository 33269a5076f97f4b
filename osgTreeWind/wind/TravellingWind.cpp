// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/TravellingWind.h>

#include <utility>

namespace osgTreeWind {

TravellingWind::TravellingWind(WindFieldPtr inner, double plane, double speed)
    : _inner(std::move(inner)), _plane(plane), _speed(speed) {}

glm::vec3 TravellingWind::velocity(const glm::vec3& position, double time) const {
    return _inner->velocity(position, time - (position.x - _plane) / _speed);
}

} // namespace osgTreeWind
