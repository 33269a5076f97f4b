// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// Synthetic gusts over the field of a wind, which is then their mean at each place and time (Wind::gusts).
///
/// The spectrum along the wind is flat at low frequencies and falls with the power -5/3 above those of the
/// length scale (Kolmogorov), over two decades. Coherence across the wind decays as exp(-8.8 f d / U) (IEC
/// 61400-1:1999). The standard deviations across the wind and upward are 0.8 and 0.5 of that along it (IEC
/// 61400-1, Kaimal). The intensity falls with the height above the ground as the inverse of the logarithmic
/// profile (EN 1991-1-4).
///
/// Strength and direction of the gusts follow the mean wind at each place. Where the field knows its
/// turbulence (WindField::turbulence()), it sets their strength, and their direction is that in which they
/// travel. All gusts travel with one velocity, as a box of turbulence does (Taylor's hypothesis; TurbSim,
/// Jonkman 2009), and change on their way (Simley and Pao 2015). It is the mean of the wind's first hour at
/// (0, 0), at the height of the field's profile, or else at 10 m.
///
///     const glm::vec3 mean = windVelocity({8.0, glm::radians(240.0)}, DirectionSense::From);
///     Wind wind(std::make_shared<UniformWind>(mean, LogProfile{10.0, 0.05}));
///     wind.gusts.intensity = 0.2;
///     report(forest->setWind(wind));
struct WindGusts {
    /// Standard deviation along the wind over the mean speed, [0, 1], at the height of the field's profile,
    /// or else at 10 m. 0: the wind as given.
    double intensity = 0.0;
    double lengthScale = 60.0; ///< Integral length scale along the wind, metres, [1, 1e5].
    std::uint32_t seed = 1;    ///< The same seed gives the same gusts.
};

} // namespace osgTreeWind
