// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowthGoal.h>
#include <osgTreeWind/growth/GrowthSite.h>
#include <osgTreeWind/growth/TreeHabit.h>

#include <cstdint>

namespace osgTreeWind {

/// A tree that grows by light. Ranges: GrowthFields.h.
struct GrowthParameters {
    GrowthGoal size;        ///< To which it grows.
    GrowthSite site;        ///< Where it stands.
    TreeHabit habit;        ///< How it grows.
    float flare = 0.5f;     ///< How much wider its bark is at the ground, over its radius there.
    std::uint32_t seed = 1; ///< One seed gives one tree, bit for bit, on every machine.
};

} // namespace osgTreeWind
