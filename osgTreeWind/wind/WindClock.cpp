// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindClock.h>

#include <cmath>

namespace osgTreeWind {

bool WindClock::isCarried() const {
    return std::isfinite(speed);
}

double WindClock::at(double x, double time) const {
    const double atPlane = start + scale * time;
    return isCarried() ? atPlane - (x - plane) / speed : atPlane;
}

WindClock WindClock::of(const WindClock& inner) const {
    WindClock both = inner;
    both.start += inner.scale * start;
    both.scale *= scale;
    if (!isCarried())
        return both;
    const double outerLag = inner.scale / speed, // s for each metre of x
        innerLag = inner.isCarried() ? 1.0 / inner.speed : 0.0;
    both.start += outerLag * plane + innerLag * inner.plane;
    both.plane = 0.0;
    both.speed = 1.0 / (outerLag + innerLag);
    return both;
}

} // namespace osgTreeWind
