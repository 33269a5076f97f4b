// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace osgTreeWind {

/// A shoot segment and the node at its end.
struct GrownMetamer {
    glm::vec3 position{0.0f}; ///< Position of the node from the tree's foot, metres, z up.
    int parent = -1;          ///< Index of the parent metamer, always a lower one; -1 for the foot.
    int axis = 0;             ///< Shoot axis; 0 is the trunk. Metamers of an axis are ordered along it.
    int order = 0;            ///< Branching order; 0 is the trunk.
    int born = 0;             ///< Year of growth, from 0.
    bool dead = false;        ///< Dead wood that has not fallen yet.
    float radius = 0.0f;      ///< Radius at the node, metres.
    float light = 1.0f;       ///< Share of full light at the node in the last year, 0 to 1.
    float leafArea = 0.0f;    ///< Leaf area in the last year, m².
};

/// Result of growTree(): the branching structure of a tree.
struct GrownForm {
    std::vector<GrownMetamer> metamers; ///< The first is the foot; parents precede their children.
    int years = 0;                      ///< Age of the tree.
    float spread = 1.0f;                ///< Factor on the vigour of boughs that gave the crown its width.
    float heightFactor = 1.0f;          ///< Vertical stretch to fit the goal.
    float widthFactor = 1.0f;           ///< Horizontal stretch to fit the goal.
};

} // namespace osgTreeWind
