// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

#include <limits>

namespace osgTreeWind {

/// Another wind at another time: at x and t it is the inner wind at start + scale * t - (x - plane) / speed.
/// Of a wind that is retimed already it takes the wind within, and one clock that is both.
class OSGTREEWIND_EXPORT RetimedWind final : public WindField {
public:
    /// Which time of the inner wind it is, and where.
    struct Clock {
        double start = 0.0; ///< Seconds of the inner wind's time shown at time 0.
        /// Seconds of the inner wind per second: with 60 an hour of record passes in a minute; 0 freezes it,
        /// a negative one runs it backwards.
        double scale = 1.0;
        /// A wind known over time at the plane x = `plane` is carried past it unchanged (Taylor's frozen
        /// turbulence) at `speed` m/s toward +x, not 0; infinite: all places have the same time.
        double plane = 0.0;
        double speed = std::numeric_limits<double>::infinity(); ///< m/s; see `plane`.
    };

    /// Null is calm.
    RetimedWind(WindFieldPtr inner, const Clock& clock);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    WindFieldPtr withoutGusts() const override;

    const WindFieldPtr& inner() const { return _inner; } ///< Never null.
    const Clock& clock() const { return _clock; }        ///< As given, or one that is two.

private:
    bool carried() const;
    double innerTime(double x, double time) const;

    WindFieldPtr _inner;
    Clock _clock;
};

} // namespace osgTreeWind
