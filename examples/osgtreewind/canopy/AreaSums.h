// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// How much plant there is.
struct AreaSums {
    double leaf = 0.0; ///< One side of leaves, m^2.
    double drag = 0.0; ///< CdA of wood and leaves in a wind of 10 m/s, m^2.

    AreaSums& operator+=(const AreaSums& other) {
        leaf += other.leaf;
        drag += other.drag;
        return *this;
    }
    AreaSums operator*(double factor) const { return {factor * leaf, factor * drag}; }
};

} // namespace osgTreeWind
