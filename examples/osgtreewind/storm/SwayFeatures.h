// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// Features of how a tree sways in a wind, computed from its bending strain, tilt or displacement.
///
/// The series is resampled to 4 Hz, drifts of ten minutes and more are removed, and the features are those of
/// its first principal component, with the sign that makes the skewness positive.
struct SwayFeatures {
    double alongOverAcross = 0.0;  ///< Variance of the first principal component over that of the second.
    double signalToNoise = 0.0;    ///< Peak of the spectrum over its level from 1.7 to 1.95 Hz.
    double frequency = 0.0;        ///< Frequency of the sway, Hz.
    std::optional<double> damping; ///< Damping ratio of an oscillator fitted to the spectrum near the sway.
    double share = 0.0;            ///< Share of the variance within half an octave of the sway.
    double skewness = 0.0, kurtosis = 0.0;
    double peak = 0.0; ///< 99.9th percentile over the standard deviation.
};

/// @param series samples along and across the wind, evenly spaced. @param rate samples per second, a multiple
/// of 4.
/// @param frequency expected frequency of the sway, Hz. @return nothing if the series is shorter than 20
/// minutes or constant, or the frequency is not between 0.02 and 2 Hz.
std::optional<SwayFeatures> swayFeatures(const std::vector<glm::dvec2>& series, double rate,
                                         double frequency);

} // namespace osgTreeWind
