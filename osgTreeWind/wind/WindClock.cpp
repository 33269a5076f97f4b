// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindClock.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// 1 / v along v: of a velocity the seconds for each metre, and back. 0 for what has no inverse.
glm::dvec2 inverse(const glm::dvec2& v) {
    const glm::dvec2 inverted = v / glm::dot(v, v);
    return std::isfinite(inverted.x) && std::isfinite(inverted.y) ? inverted : glm::dvec2(0.0);
}

} // namespace

bool WindClock::travels() const {
    return lag() != glm::dvec2(0.0);
}

glm::dvec2 WindClock::lag() const {
    return inverse(travel);
}

double WindClock::at(const glm::dvec2& place, double time) const {
    return start + scale * time - glm::dot(lag(), place - origin);
}

WindClock WindClock::of(const WindClock& inner) const {
    WindClock both = inner;
    both.start += inner.scale * start;
    both.scale *= scale;
    if (!travels())
        return both;
    if (!inner.travels()) { // without rounding
        both.travel = inner.scale != 0.0 ? travel / inner.scale : glm::dvec2(0.0);
        both.origin = origin;
        return both;
    }
    both.start += inner.scale * glm::dot(lag(), origin) + glm::dot(inner.lag(), inner.origin);
    both.origin = glm::dvec2(0.0);
    both.travel = inverse(inner.scale * lag() + inner.lag());
    return both;
}

} // namespace osgTreeWind
