// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

namespace osgTreeWind {

/// How wind measured at one height grows with height above the ground: the logarithmic law of the neutral
/// surface layer, u(z) = u(height) * ln(z / roughness) / ln(height / roughness).
struct OSGTREEWIND_EXPORT LogProfile {
    double height = 10.0;   ///< Metres above ground of the measurement; above the roughness length.
    double roughness = 0.1; ///< Roughness length z0 of the ground, metres, above 0.

    /// Whether both are finite and 0 < roughness < height.
    bool valid() const;

    /// u(z) / u(height) for z in metres above the ground: 1 at `height`, 0 at and below `roughness`, finite
    /// for any z. Only when valid().
    double factor(double z) const;
};

} // namespace osgTreeWind
