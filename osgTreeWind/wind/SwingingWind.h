// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyProfile.h>

namespace osgTreeWind {

/// A level wind of which both speed and direction vary: a speed with mean, deviation and skewness, toward a
/// Gaussian angle off the mean direction. Strong gusts then swing further to the side than weak ones.
struct SwingingWind {
    float cosine;                    ///< Mean of the angle's cosine.
    float mean, deviation, skewness; ///< Of the speed.

    /// That has this mean, spread and skewness along its mean direction. Not for a calm.
    SwingingWind(float along, const WindSpread& spread, float skewAlong);

    /// Deviation of the angle, radians.
    float swing() const;
    /// Mean of its pressure along the mean direction, over that of a steady wind of speed 1.
    float push() const { return cosine * (mean * mean + deviation * deviation); }
};

} // namespace osgTreeWind
