// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Standard deviations of a wind over its mean speed at the canopy's top.
struct WindSpread {
    float along = 0.0f, across = 0.0f, up = 0.0f;
};

/// How wind grows with height in and over a stand of trees, over its mean at their tops: exponential below
/// (Cionco 1965), even within the roughness sublayer, logarithmic above it (Raupach 1994).
struct CanopyProfile {
    float height = 0.0f;      ///< Of the canopy's top, metres, above 0.
    float friction = 0.0f;    ///< u*, over the mean at the top.
    float attenuation = 0.0f; ///< a in exp(-a (1 - z/height)), above 0.

    /// Of a stand with that height and frontal area index: half of the area of leaves, and the area of wood
    /// seen from the side, over that of the ground; above 0.
    static CanopyProfile over(float height, float frontalArea);

    /// Zero-plane displacement over the height.
    float displacement() const;
    /// Mean at z metres above the ground. Finite for any z.
    float mean(float z) const;
    WindSpread spread(float z) const;
    /// Skewness of the wind along its mean; that of the wind upward is its negative.
    float skewness(float z) const;
};

/// Share of the momentum of a closed stand that one with this frontal area index takes, 0 to 1.
float closureOf(float frontalArea);

} // namespace osgTreeWind
