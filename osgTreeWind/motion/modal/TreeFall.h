// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/RotationAbout.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>

namespace osgTreeWind {

/// Fallen parts of a tree: units that have turned about their bases, with their descendants.
struct TreeFall {
    struct Part {
        unsigned unit = 0;
        glm::vec2 turn{0.0f}; ///< Horizontal rotation vector in the tree's own axes, radians.

        glm::quat rotation() const {
            const float angle = glm::length(turn);
            return angle > 0.0f ? rotationAbout(glm::vec3(turn / angle, 0.0f), angle)
                                : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
        }
    };
    static constexpr std::size_t maxParts = 4; ///< Three boughs and then the trunk.
    std::array<Part, maxParts> parts{};        ///< The first `count` are used.
    std::size_t count = 0;
    bool isDown = false; ///< Whether the last part is the trunk.
    float sway = 1.0f;   ///< Remaining share of sway and wind; 0 for a tree at rest on the ground.

    glm::vec2 trunkTurn() const { return isDown ? parts[count - 1].turn : glm::vec2(0.0f); }
    /// Applies the fall of a unit, if any, to its rotation.
    glm::quat turned(std::size_t unit, glm::quat rotation) const {
        for (std::size_t i = 0; i < count; ++i)
            if (parts[i].unit == unit)
                rotation = parts[i].rotation() * rotation;
        return rotation;
    }
};

} // namespace osgTreeWind
