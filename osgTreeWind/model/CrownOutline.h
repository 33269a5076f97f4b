// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// The outline of a crown, by Weber and Penn 1995.
enum class CrownOutline {
    Cone,            ///< 0.2 + 0.8 r
    Sphere,          ///< 0.2 + 0.8 sin(pi r)
    Hemisphere,      ///< 0.2 + 0.8 sin(pi r / 2)
    Cylinder,        ///< 1
    TaperedCylinder, ///< 0.5 + 0.5 r
    Flame,           ///< r / 0.7 up to 0.7, then (1 - r) / 0.3
    InverseCone,     ///< 1 - 0.8 r
    TendFlame,       ///< 0.5 + 0.5 of the flame
};

/// Width of the crown over its largest one. @param r 0 at its top, 1 at its base.
float crownWidth(CrownOutline outline, float r);

} // namespace osgTreeWind
