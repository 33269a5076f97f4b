// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Standard deviations of the wind, relative to its mean speed at the canopy top.
struct WindSpread {
    float along = 0.0f, across = 0.0f, up = 0.0f;
};

/// Deviations over u* at the canopy top (Raupach, Finnigan and Brunet 1996).
constexpr WindSpread spreadAtTop{1.8f, 1.6f, 1.1f};

/// Wind profile in and above a stand of trees, relative to the mean wind at the canopy top: exponential in
/// the canopy (Cionco 1965), linear in the roughness sublayer, logarithmic above it (Raupach 1994).
struct CanopyProfile {
    float height = 0.0f;      ///< Height of the canopy top, metres, above 0.
    float friction = 0.0f;    ///< Friction velocity u* over the mean wind at the top.
    float attenuation = 0.0f; ///< Coefficient a in exp(-a (1 - z/height)), above 0.

    /// The profile of a stand. @param height metres, above 0. @param frontalArea frontal area index, above 0:
    /// half of the leaf area, plus the area of wood seen from the side, per ground area.
    static CanopyProfile ofStand(float height, float frontalArea);

    /// Zero-plane displacement over `height`.
    float displacement() const;
    /// Roughness length, metres.
    float roughness() const;
    /// Mean wind at the top over that of open country at a height, metres, of at least the top. From the edge
    /// of the forest grows a layer of air that its roughness has slowed (Elliott 1958). Up to `reference` it
    /// has no effect; above, the friction velocity falls, down to that of an endless forest (EN 1991-1-4).
    /// @param extent side of a square as large as the forest, metres.
    float topSpeedRatio(float reference, float extent) const;
    /// Mean wind at z metres above the ground. Finite for any z.
    float mean(float z) const;
    WindSpread spread(float z) const;
    /// Skewness of the wind component along the mean; the vertical component has the negative of it.
    float skewness(float z) const;
};

/// Momentum absorbed by a stand with this frontal area index, relative to a closed stand, [0, 1].
float closureOf(float frontalArea);

} // namespace osgTreeWind
