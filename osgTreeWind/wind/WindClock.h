// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Maps a scene time t and a place p to a time of the wind data: start + scale * t - lag() . (p - origin).
struct OSGTREEWIND_EXPORT WindClock {
    double start = 0.0; ///< Time of the data at scene time 0, seconds.
    /// Seconds of data per second of the scene: 60 plays an hour in a minute, 0 freezes, negative reverses.
    double scale = 1.0;
    /// Velocity along x and y, metres per second of data, at which the wind recorded at `origin` travels
    /// unchanged (frozen turbulence, Taylor 1938): places downwind get it later. (0, 0): all places have the
    /// same time.
    glm::dvec2 travel{0.0};
    glm::dvec2 origin{0.0}; ///< Where the wind was recorded, metres; see `travel`.

    /// Whether data time equals scene time everywhere.
    bool isIdentity() const { return start == 0.0 && scale == 1.0 && !travels(); }
    /// Whether the data time depends on the place.
    bool travels() const;
    /// Delay of the wind per metre along x and y, seconds of data per metre.
    glm::dvec2 lag() const;
    /// The data time, seconds. @param place x and y, metres. @param time scene time, seconds.
    double at(const glm::dvec2& place, double time) const;
    /// This clock followed by `next`, which maps the times that this one returns.
    WindClock then(const WindClock& next) const;
};

} // namespace osgTreeWind
