// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyProfile.h>

namespace osgTreeWind {

/// A horizontal wind of varying speed and direction: a skewed distribution of speeds, and a Gaussian angle to
/// the mean direction. Strong gusts therefore deviate further sideways than weak ones.
struct SwingingWind {
    float cosine;                    ///< Mean cosine of the angle.
    float mean, deviation, skewness; ///< Moments of the speed.

    /// Matches the mean, spread and skewness of the component along the mean direction. @param along above 0.
    SwingingWind(float along, const WindSpread& spread, float skewAlong);

    /// Standard deviation of the angle, radians.
    float swing() const;
    /// Mean dynamic pressure along the mean direction, relative to a steady wind of speed 1.
    float meanPressure() const { return cosine * (mean * mean + deviation * deviation); }
};

} // namespace osgTreeWind
