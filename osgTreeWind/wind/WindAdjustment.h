// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/mat3x3.hpp>

namespace osgTreeWind {

/// Makes a wind stronger or weaker, and turns its velocities about the vertical where they are.
struct OSGTREEWIND_EXPORT WindAdjustment {
    double strength = 1.0; ///< Factor of velocities, [0, 10].
    double turn = 0.0;     ///< Degrees clockwise from above, [-360, 360].

    /// Whether it leaves a wind as it is.
    bool isNone() const { return strength == 1.0 && turn == 0.0; }
    /// Takes a velocity to the adjusted one. Values out of range are clamped; one that is not finite counts
    /// as the default.
    glm::mat3 matrix() const;
};

} // namespace osgTreeWind
