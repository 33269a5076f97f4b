// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Which time of a wind's data is shown at a time of the scene, and where. At p and t that is
/// start + scale * t - lag() . (p - origin).
struct OSGTREEWIND_EXPORT WindClock {
    double start = 0.0; ///< Seconds of the data's time shown at time 0.
    /// Seconds of data per second: with 60 an hour of record passes in a minute; 0 freezes it, a negative one
    /// runs it backwards.
    double scale = 1.0;
    /// A wind that is known over time at one place travels from there unchanged (frozen turbulence, Taylor
    /// 1938) with this velocity, m/s toward x and y: what lies downwind has it later. 0, 0: all places have
    /// the same time.
    glm::dvec2 travel{0.0};
    glm::dvec2 origin{0.0}; ///< The place where it is known, metres; see `travel`.

    /// Whether it shows the data's own time everywhere.
    bool isNone() const { return start == 0.0 && scale == 1.0 && !travels(); }
    /// Whether places have times of their own.
    bool travels() const;
    /// How much later each place has the wind, s/m toward x and y.
    glm::dvec2 lag() const;
    /// The data's time, seconds. @param place x and y, metres. @param time of the scene, seconds.
    double at(const glm::dvec2& place, double time) const;
    /// One clock for two: what `inner` shows at the time that this one shows.
    WindClock of(const WindClock& inner) const;
};

} // namespace osgTreeWind
