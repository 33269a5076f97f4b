// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/mat3x3.hpp>

namespace osgTreeWind {

/// Scales the velocities of a wind and turns them about the vertical, without moving their places.
struct OSGTREEWIND_EXPORT WindAdjustment {
    double strength = 1.0; ///< Factor, [0, 10].
    double turn = 0.0;     ///< Degrees clockwise as seen from above, [-360, 360].

    /// Whether it changes nothing.
    bool isIdentity() const { return strength == 1.0 && turn == 0.0; }
    /// The matrix from original to adjusted velocities. Values out of range are clamped; values that are not
    /// finite are replaced by the defaults.
    glm::mat3 matrix() const;
};

} // namespace osgTreeWind
