// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

namespace osgTreeWind {

/// How far a tree has come down: a unit of its trunk has turned about its base, with all that it carries.
struct TreeFall {
    unsigned unit = 0;
    glm::vec2 turn{0.0f}; ///< Rotation vector, level, in the tree's own axes; radians.
    float sway = 1.0f;    ///< Share of its sway, and of the wind, that is left to it: 0 for one that lies.

    float angle() const { return glm::length(turn); }
    glm::quat rotation() const {
        const float angle = this->angle();
        return angle > 0.0f ? glm::angleAxis(angle, glm::vec3(turn / angle, 0.0f))
                            : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    }
};

} // namespace osgTreeWind
