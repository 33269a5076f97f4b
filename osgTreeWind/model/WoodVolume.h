// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <vector>

namespace osgTreeWind {

/// Of a cone that is cut off, m^3. @param a, b its radii, metres.
double frustumVolume(double length, double a, double b);

/// Volume of the wood of a skeleton along its centre lines, shoots among it, m^3.
double woodVolume(const Skeleton& skeleton);

/// The wood of the shoots that a unit bears.
struct ShootWood {
    float volume = 0.0f;  ///< m^3.
    float outline = 0.0f; ///< Diameter times length, m^2: what the wind meets across them.
    float upright = 0.0f; ///< Mean square of the sine of their elevation, by length.

    ShootWood scaled(const glm::vec3& axes, float radius) const; ///< In a tree that is stretched so.
};

/// Of each unit; empty where the skeleton has no shoots.
std::vector<ShootWood> shootWoodOf(const Skeleton& skeleton);

} // namespace osgTreeWind
