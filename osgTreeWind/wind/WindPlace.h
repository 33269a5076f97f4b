// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/PlaceInStand.h>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// A place at which the wind is sampled: its position and its height above the ground.
struct WindPlace {
    glm::vec3 position{0.0f}; ///< Metres.
    float height = 0.0f;      ///< Metres above the ground.
    bool inCrown = false; ///< Between the leaves of a tree, where the crown itself slows the wind in a stand.
    /// Where the wind may keep what it knows of this place until the next sample; null: nowhere. For one
    /// thread at a time.
    PlaceInStand* stand = nullptr;

    WindPlace() = default;
    /// A place above ground at z = `ground`.
    WindPlace(const glm::vec3& at, float ground = 0.0f) : position(at), height(at.z - ground) {}
    /// A place above ground at z = 0.
    WindPlace(float x, float y, float z) : position(x, y, z), height(z) {}
};

} // namespace osgTreeWind
