// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/mat3x3.hpp>

namespace osgTreeWind {

/// Scales the velocities of a wind and turns them about the vertical, without moving their places.
struct OSGTREEWIND_EXPORT WindAdjustment {
    double strength = 1.0; ///< Factor, [0, 10].
    float turn = 0.0f;     ///< Radians clockwise as seen from above, at most a full turn.

    /// Whether it changes nothing.
    bool isIdentity() const { return strength == 1.0 && turn == 0.0f; }
    /// The matrix from original to adjusted velocities. Values out of range are clamped; values that are not
    /// finite are replaced by the defaults.
    glm::mat3 matrix() const;
};

} // namespace osgTreeWind
