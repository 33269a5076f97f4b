// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// A palm: a bare stem and a head of fronds. Lengths in metres, angles in radians; ranges: TreeKeys.h.
struct PalmParameters {
    float height = 14.0f;           ///< Of the highest frond.
    float trunkDiameter = 0.35f;    ///< At breast height; at most half the height of the stem.
    float crownWidth = 4.8f;        ///< From 0.01 to 4 heights.
    float crownBase = 0.81f;        ///< Height of the oldest frond's foot over that of the palm.
    float trunk = 0.84f;            ///< Height of the stem over that of the palm, at least crownBase.
    float trunkTaper = 0.75f;       ///< Radius at the top of the stem over that at the ground.
    float trunkCrook = 0.1f;        ///< Curvature of the stem.
    float flare = 0.25f;            ///< Widening of the stem at the ground over its radius (StemFoot.h).
    int fronds = 48;                ///< Number of fronds.
    float inclination = 2.3562f;    ///< Angle of the oldest frond from the stem.
    float inclinationEnd = 0.2618f; ///< Angle of the youngest frond from the stem.
    float droop = 1.4835f;          ///< Downward bend of a frond from foot to end.
    float frondRadius = 0.0155f;    ///< Radius of a frond's stalk at its foot.
    std::uint32_t seed = 1;         ///< One seed gives one palm, bit for bit, on every machine.
};

} // namespace osgTreeWind
