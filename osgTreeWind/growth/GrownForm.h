// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace osgTreeWind {

/// A piece of shoot with the node at its end.
struct GrownMetamer {
    glm::vec3 position{0.0f}; ///< Of the node, metres, z up, from the tree's foot.
    int parent = -1;          ///< Index of the metamer before it, always a lower one; -1: the foot.
    int axis = 0;             ///< 0: the trunk. Metamers of one axis follow each other along it.
    int order = 0;            ///< Of branching: 0 the trunk, 1 what it bears, ...
    int born = 0;             ///< Year, 0 the first.
    bool dead = false;        ///< Bare wood that has not fallen yet.
    float radius = 0.0f;      ///< At the node, metres.
    float light = 1.0f;       ///< At the node in the last year, 0 to 1 of full light.
    float leafArea = 0.0f;    ///< Of its leaves in the last year, m²; 0: none.
};

/// A tree that has grown.
struct GrownForm {
    std::vector<GrownMetamer> metamers; ///< The first is the foot; parents before children.
    int years = 0;                      ///< Its age.
    float spread = 1.0f; ///< Vigour of its boughs over that of the habit, which gave the crown its width.
    float heightFactor = 1.0f; ///< By which it was stretched upwards to fit its goal.
    float widthFactor = 1.0f;  ///< Likewise sideways.
};

} // namespace osgTreeWind
