// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <vector>

namespace osgTreeWind {

/// Volume of a truncated cone, m^3. @param a, b its radii, metres.
double frustumVolume(double length, double a, double b);

/// Volume of a skeleton's wood along its centre lines, including shoots, m^3.
double woodVolume(const Skeleton& skeleton);

/// Total of the shoots that a unit bears.
struct ShootWood {
    float volume = 0.0f;  ///< m^3
    float outline = 0.0f; ///< Diameter times length, m^2; the area exposed to the wind.
    float upright = 0.0f; ///< Mean square of the sine of their elevation, weighted by length.

    ShootWood scaled(const glm::vec3& axes, float radius) const; ///< In a tree at that TreeScale.
};

/// Totals per unit; empty if the skeleton has no shoots.
std::vector<ShootWood> shootWoodOf(const Skeleton& skeleton);

} // namespace osgTreeWind
