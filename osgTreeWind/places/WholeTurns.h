// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace osgTreeWind {

/// Degrees to add to a longitude, for the same meridian within half a turn of another one.
inline double wholeTurns(double longitude, double other) {
    return 360.0 * std::round((other - longitude) / 360.0);
}

} // namespace osgTreeWind
