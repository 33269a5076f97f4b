// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

namespace osgTreeWind {

/// Roughness length of short grass, metres (Wieringa 1993).
constexpr double openCountryRoughness = 0.03;

/// Logarithmic wind profile of the neutral surface layer:
/// u(z) = u(height) * ln(z / roughness) / ln(height / roughness).
struct OSGTREEWIND_EXPORT LogProfile {
    double height = 10.0;   ///< Height of the measurement above the ground, metres, above `roughness`.
    double roughness = 0.1; ///< Roughness length z0 of the ground, metres, above 0.

    /// Whether both are finite and 0 < roughness < height.
    bool valid() const;

    /// u(z) / u(height) at z metres above the ground; 0 for z <= roughness, always finite. Requires valid().
    double factor(double z) const;
};

} // namespace osgTreeWind
