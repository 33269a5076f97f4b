// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Golden angle, radians: rotation from whorl to whorl of a trunk, and from limb to limb.
constexpr float whorlAngle = 2.399963f;

/// Position and direction of a side bud on its axis.
struct BudPlace {
    int node = 0;                        ///< Index of the metamer that bears it.
    glm::vec3 heading{0.0f, 0.0f, 1.0f}; ///< Direction of the axis there.
    int order = 0;                       ///< Branching order of the axis.
    float azimuth = 0.0f;                ///< Around the axis, radians.
    float angle = 1.0f;                  ///< From the axis, radians.
};

/// Adds a side bud and the axis of `order` that it will begin. @return the bud; valid until the next is
/// added.
Bud& addSideBud(TreeState& tree, const BudPlace& place, int order);

/// Adds the side buds at the node of the terminal bud `end`.
/// @param along share of the year's shoot below the node. @param last whether it is the shoot's last node.
void addSideBuds(TreeState& tree, const Bud& end, float along, bool last);

/// Random number with a triangular distribution from -1 to 1.
float triangular(Random& random);

} // namespace osgTreeWind
