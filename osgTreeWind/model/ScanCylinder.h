// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// A piece of a tree's wood as laser scans are fitted: a round cylinder, and which one it springs from.
struct ScanCylinder {
    glm::dvec3 start{0.0}; ///< Of its axis, metres, z up; coordinates of a map are welcome.
    glm::dvec3 end{0.0};   ///< Likewise.
    double radius = 0.0;   ///< Metres.
    int parent = -1;       ///< Index of the cylinder it springs from; -1 for the root. Any order.
    int line = 0;          ///< Of the file it stands in, 1-based; 0 when unknown.
};

/// All cylinders of one tree.
using ScanCylinders = std::vector<ScanCylinder>;

/// What keeps the cylinders from being one tree, with its line: no cylinder, a radius outside (0, 10] m or a
/// length below a micrometre, no root or two, a parent that is not there, a loop, a height above the foot
/// outside 0.1 to 150 m, or an extent of over 200 m. Nothing for a sound tree.
std::optional<Diagnostic> problemOfScan(const ScanCylinders& cylinders);

} // namespace osgTreeWind
