// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>

namespace osgTreeWind {

/// What of a tree has come down, and how far: units of it have turned about their bases, with all that they
/// carry.
struct TreeFall {
    struct Part {
        unsigned unit = 0;
        glm::vec2 turn{0.0f}; ///< Rotation vector, level, in the tree's own axes; radians.

        glm::quat rotation() const {
            const float angle = glm::length(turn);
            return angle > 0.0f ? glm::angleAxis(angle, glm::vec3(turn / angle, 0.0f))
                                : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
        }
    };
    static constexpr std::size_t mostParts = 4; ///< Three boughs and then the trunk.
    std::array<Part, mostParts> parts{};        ///< The first `count` of them.
    std::size_t count = 0;
    bool isDown = false; ///< The trunk is the last part.
    float sway = 1.0f;   ///< Share of its sway, and of the wind, that is left to it: 0 for one that lies.

    glm::vec2 trunkTurn() const { return isDown ? parts[count - 1].turn : glm::vec2(0.0f); }
    /// The rotation of a unit, turned as far as that has come down.
    glm::quat turned(std::size_t unit, glm::quat rotation) const {
        for (std::size_t i = 0; i < count; ++i)
            if (parts[i].unit == unit)
                rotation = parts[i].rotation() * rotation;
        return rotation;
    }
};

} // namespace osgTreeWind
