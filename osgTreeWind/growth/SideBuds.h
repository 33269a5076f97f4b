// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Turn from whorl to whorl of a trunk, and from limb to limb.
constexpr float goldenTurn = 2.399963f;

/// Where a side bud sits on its axis.
struct BudPlace {
    int node = 0;                        ///< Index of the metamer that bears it.
    glm::vec3 heading{0.0f, 0.0f, 1.0f}; ///< Of the axis there.
    int order = 0;                       ///< Of the axis.
    float azimuth = 0.0f;                ///< About the axis, radians.
    float angle = 1.0f;                  ///< From the axis, radians.
};

/// Adds a side bud and an axis of `order` that it will begin. @return the bud, until the next is added.
Bud& addSideBud(TreeState& tree, const BudPlace& place, int order);

/// Adds the side buds of the node at the end of a shoot that `end` is to continue.
/// @param along share of the year's shoot below the node. @param last it is the last node of that shoot.
void addSideBuds(TreeState& tree, const Bud& end, float along, bool last);

/// A random number from -1 to 1, mostly near 0.
float scatter(Random& random);

} // namespace osgTreeWind
