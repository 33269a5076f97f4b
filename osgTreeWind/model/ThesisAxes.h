// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Conversion between the thesis' axes (Y up) and OSG's (Z up, x east, y north). Both are proper rotations,
/// so they apply to points, velocities and rotation axes alike.
inline glm::vec3 fromThesis(const glm::vec3& v) {
    return {v.x, -v.z, v.y};
}
inline glm::vec3 toThesis(const glm::vec3& v) {
    return {v.x, v.z, -v.y};
}

} // namespace osgTreeWind
