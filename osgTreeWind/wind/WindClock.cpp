// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindClock.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// A vector along v of length 1 / |v|, which converts between velocity and s/m; 0 if v has no inverse.
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

WindClock WindClock::then(const WindClock& next) const {
    WindClock both = next;
    both.start += next.scale * start;
    both.scale *= scale;
    if (!travels())
        return both;
    if (!next.travels()) { // avoids rounding
        both.travel = next.scale != 0.0 ? travel / next.scale : glm::dvec2(0.0);
        both.origin = origin;
        return both;
    }
    both.start += next.scale * glm::dot(lag(), origin) + glm::dot(next.lag(), next.origin);
    both.origin = glm::dvec2(0.0);
    both.travel = inverse(next.scale * lag() + next.lag());
    return both;
}

} // namespace osgTreeWind
