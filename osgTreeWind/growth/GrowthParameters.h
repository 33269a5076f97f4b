// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowthGoal.h>
#include <osgTreeWind/growth/GrowthSite.h>
#include <osgTreeWind/growth/TreeHabit.h>

#include <cstdint>

namespace osgTreeWind {

/// Parameters of a tree that grows by light. GrowthKeys.h has the ranges.
struct GrowthParameters {
    GrowthGoal size;        ///< Size of the grown tree.
    GrowthSite site;        ///< Neighbours of the tree.
    TreeHabit habit;        ///< Growth habit of the species.
    float flare = 0.5f;     ///< Widening of the bark at the ground / trunk radius there.
    std::uint32_t seed = 1; ///< One seed gives one tree, bit for bit, on every machine.
};

} // namespace osgTreeWind
