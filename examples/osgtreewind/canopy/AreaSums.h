// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Leaf area and drag area of plants.
struct AreaSums {
    double leaf = 0.0; ///< One-sided leaf area, m^2.
    double drag = 0.0; ///< CdA of wood and leaves in a wind of 10 m/s, m^2.

    AreaSums& operator+=(const AreaSums& other) {
        leaf += other.leaf;
        drag += other.drag;
        return *this;
    }
    AreaSums operator*(double factor) const { return {factor * leaf, factor * drag}; }
};

} // namespace osgTreeWind
