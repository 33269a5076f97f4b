// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>

namespace osgTreeWind {

/// Interactive control of a wind: its speed, direction and gustiness.
///
/// Uniform winds and calms are synthetic, and take any speed and direction. All other winds (measured,
/// computed or the host's) can only be scaled and turned (WindAdjustment). Any wind can have gusts
/// (Wind::gusts).
struct WindSteering {
    static constexpr double maxSpeed = 60.0, maxStrength = 10.0;

    bool isSynthetic = true;
    double speed = 0.0;     ///< m/s at the height of the profile, at most maxSpeed.
    double from = 270.0;    ///< Degrees clockwise from north, [0, 360).
    double gustiness = 0.0; ///< Standard deviation along the wind over the mean speed, [0, 1].
    double strength = 1.0;  ///< Factor of a wind that is not synthetic, at most maxStrength.
    double turn = 0.0;      ///< Turn of such a wind, degrees clockwise, (-360, 360).

    /// Adds to the speed of a synthetic wind; adds 0.1 to the strength of another wind for each m/s.
    void strengthen(double metresPerSecond);
    void turnClockwise(double degrees);
    void changeGustiness(double by);
};

/// The current control values of a wind.
WindSteering steeringOf(const Wind& wind);

/// A wind with these control values. Keeps everything else of `like`: the profile, the length scale and seed
/// of the gusts, the clock, frame, canopy and sources. @param like the wind passed to steeringOf().
Wind steered(Wind like, const WindSteering& steering);

} // namespace osgTreeWind
