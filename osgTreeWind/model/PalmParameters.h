// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// A palm: a bare stem and a head of fronds. Lengths in metres, angles in radians; ranges: TreeFields.h.
struct PalmParameters {
    float height = 14.0f;        ///< Of the highest frond.
    float trunkDiameter = 0.35f; ///< At breast height, at most half the height of the stem.
    float crownWidth = 4.8f;     ///< From end to end of fronds, at least 0.01 and at most 4 heights.
    float crownBase = 0.81f;     ///< Height of the oldest frond's foot over that of the palm.
    float trunk = 0.84f;         ///< Height of the stem over that of the palm, at least crownBase.
    float trunkTaper = 0.75f;    ///< Radius at the top of the stem over that at the ground.
    float trunkCrook = 0.1f;     ///< How far the stem winds.
    float flare = 0.25f;         ///< How much wider the stem is at the ground, over its radius: StemFoot.h.
    int fronds = 48;             ///< How many it has.
    float inclination = 2.3562f; ///< Of the oldest frond from the stem.
    float inclinationEnd = 0.2618f; ///< Of the youngest frond from the stem.
    float droop = 1.4835f;          ///< By which a frond bends down from its foot to its end.
    float frondRadius = 0.0155f;    ///< Of a frond's stalk at its foot.
    std::uint32_t seed = 1;         ///< One seed gives one palm, bit for bit, on every machine.
};

} // namespace osgTreeWind
