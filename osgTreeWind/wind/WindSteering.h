// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>

namespace osgTreeWind {

/// A wind as one steers it by hand.
///
/// Gusts, a uniform wind and a calm are made up: they take any speed and direction. Another wind is what it
/// is, measured, computed or a host's: it can be made stronger and turned (WindAdjustment).
struct WindSteering {
    static constexpr double fastest = 60.0, strongest = 10.0;

    bool isMadeUp = true;
    double speed = 0.0;     ///< m/s at the height at which it is given, at most `fastest`.
    double from = 270.0;    ///< Degrees clockwise from north, [0, 360).
    double gustiness = 0.0; ///< Standard deviation along the wind over mean speed, [0, 1].
    double strength = 1.0;  ///< Of another wind: over what it was, at most `strongest`,
    double turn = 0.0;      ///< degrees clockwise, (-360, 360).

    /// A mean speed more, or a tenth of what another wind was for each m/s.
    void strengthen(double metresPerSecond);
    void turnClockwise(double degrees);
    /// Leaves another wind as gusty as it is.
    void changeGustiness(double by);
};

/// How a wind stands.
WindSteering steeringOf(const Wind& wind);

/// A wind like the one that is steered: it keeps its profile, the size of its gusts, their seed, and all that
/// is done to it but its adjustment.
/// @param like of which steeringOf() was.
Wind steered(Wind like, const WindSteering& steering);

} // namespace osgTreeWind
