// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/RetimedWind.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <cmath>
#include <utility>

namespace osgTreeWind {

RetimedWind::RetimedWind(WindFieldPtr inner, const Clock& clock)
    : _inner(inner ? std::move(inner) : std::make_shared<UniformWind>(glm::vec3(0.0f))), _clock(clock) {}

bool RetimedWind::carried() const {
    return std::isfinite(_clock.speed);
}

double RetimedWind::innerTime(double x, double time) const {
    const double atPlane = _clock.start + _clock.scale * time;
    return carried() ? atPlane - (x - _clock.plane) / _clock.speed : atPlane;
}

glm::vec3 RetimedWind::velocity(const WindPlace& place, double time) const {
    return _inner->velocity(place, innerTime(place.position.x, time));
}

void RetimedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    if (carried())
        WindField::sample(places, count, time, out);
    else
        _inner->sample(places, count, innerTime(0.0, time), out);
}

} // namespace osgTreeWind
