// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Where wind is asked for: a position, and how far above the ground that is. Metres.
struct WindPlace {
    glm::vec3 position{0.0f}; ///< Metres.
    float height = 0.0f;      ///< Above the ground below it.
    bool inCrown = false;     ///< Between the leaves of a tree: a stand shelters them from the air around it.

    WindPlace() = default;
    /// Over ground at z = `ground`.
    WindPlace(const glm::vec3& at, float ground = 0.0f) : position(at), height(at.z - ground) {}
    /// Over ground at z = 0.
    WindPlace(float x, float y, float z) : position(x, y, z), height(z) {}
};

} // namespace osgTreeWind
