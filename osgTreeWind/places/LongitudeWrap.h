// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

/// The multiple of 360 degrees that brings a longitude within 180 degrees of a reference.
inline double longitudeWrap(double longitude, double reference) {
    return 360.0 * std::round((reference - longitude) / 360.0);
}

} // namespace osgTreeWind
