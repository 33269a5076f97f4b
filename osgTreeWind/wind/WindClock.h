// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <limits>

namespace osgTreeWind {

/// Which time of a wind's data is shown at a time of the scene, and where. At x and t that is
/// start + scale * t - (x - plane) / speed.
struct OSGTREEWIND_EXPORT WindClock {
    double start = 0.0; ///< Seconds of the data's time shown at time 0.
    /// Seconds of data per second: with 60 an hour of record passes in a minute; 0 freezes it, a negative one
    /// runs it backwards.
    double scale = 1.0;
    /// A wind known over time at the plane x = `plane` is carried past it unchanged (Taylor's frozen
    /// turbulence) at `speed` m/s toward +x, not 0. Infinite: all places have the same time.
    double plane = 0.0;
    double speed = std::numeric_limits<double>::infinity(); ///< m/s; see `plane`.

    /// Whether it shows the data's own time everywhere.
    bool isNone() const { return start == 0.0 && scale == 1.0 && !isCarried(); }
    /// Whether places have times of their own.
    bool isCarried() const;
    /// The data's time, seconds. @param x of the place, metres. @param time of the scene, seconds.
    double at(double x, double time) const;
    /// One clock for two: what `inner` shows at the time that this one shows.
    WindClock of(const WindClock& inner) const;
};

} // namespace osgTreeWind
