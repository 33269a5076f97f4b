// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/RetimedWind.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

/// One clock for two: what `inner` shows at the time that `outer` shows.
RetimedWind::Clock composed(const RetimedWind::Clock& outer, const RetimedWind::Clock& inner) {
    RetimedWind::Clock both = inner;
    both.start += inner.scale * outer.start;
    both.scale *= outer.scale;
    if (!std::isfinite(outer.speed))
        return both;
    const double outerLag = inner.scale / outer.speed, // s for each metre of x
        innerLag = std::isfinite(inner.speed) ? 1.0 / inner.speed : 0.0;
    both.start += outerLag * outer.plane + innerLag * inner.plane;
    both.plane = 0.0;
    both.speed = 1.0 / (outerLag + innerLag);
    return both;
}

} // namespace

RetimedWind::RetimedWind(WindFieldPtr inner, const Clock& clock)
    : _inner(inner ? std::move(inner) : std::make_shared<UniformWind>(glm::vec3(0.0f))), _clock(clock) {
    if (const auto retimed = std::dynamic_pointer_cast<const RetimedWind>(_inner)) {
        _inner = retimed->_inner;
        _clock = composed(clock, retimed->_clock);
    }
}

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

WindFieldPtr RetimedWind::withoutGusts() const {
    WindFieldPtr inner = _inner->withoutGusts();
    return inner ? std::make_shared<RetimedWind>(std::move(inner), _clock) : nullptr;
}

} // namespace osgTreeWind
