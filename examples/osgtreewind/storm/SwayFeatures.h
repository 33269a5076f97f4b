// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// How a tree sways in a wind, in numbers free of units: of any of bending strain, tilt and displacement.
///
/// The series is brought to 4 Hz, drifts over ten minutes and more are taken away, and its first principal
/// component, turned so that its skewness is positive, is looked at.
struct SwayFeatures {
    double alongOverAcross = 0.0;  ///< Variance of the first principal component over that of the second.
    double signalToNoise = 0.0;    ///< Peak of the spectrum over what is there from 1.7 to 1.95 Hz.
    double frequency = 0.0;        ///< Of the sway, Hz.
    std::optional<double> damping; ///< Ratio, by an oscillator fitted to the spectrum around the sway.
    double share = 0.0;            ///< Of the variance, within half an octave of the sway.
    double skewness = 0.0, kurtosis = 0.0;
    double peak = 0.0; ///< 99.9th percentile over the standard deviation.
};

/// @param series at even steps. @param rate of it, Hz, a multiple of 4. @param frequency where the sway is
/// looked for, Hz. @return nothing where the series is shorter than 20 minutes, or the sway is not between
/// 0.02 and 2 Hz.
std::optional<SwayFeatures> swayFeatures(const std::vector<glm::dvec2>& series, double rate,
                                         double frequency);

} // namespace osgTreeWind
