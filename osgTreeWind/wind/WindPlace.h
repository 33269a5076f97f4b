// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Where wind is asked for: a position in the scene, and the ground that it stands above. Metres.
struct WindPlace {
    glm::vec3 position{0.0f};
    float ground = 0.0f; ///< Scene z of the ground below it.

    WindPlace() = default;
    WindPlace(const glm::vec3& at, float groundBelow = 0.0f) : position(at), ground(groundBelow) {}
    /// Over ground at z = 0.
    WindPlace(float x, float y, float z) : position(x, y, z) {}

    float height() const { return position.z - ground; }
};

} // namespace osgTreeWind
