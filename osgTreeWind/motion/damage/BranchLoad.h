// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Bending at the base of a branch unit at one time, by weight, air and inertia, beyond that at rest. Vectors
/// are in the axes of the forest: x and y horizontal, z up.
struct BranchLoad {
    /// N m; points to where it turns the tip of the unit, across the unit at rest. Its length is the moment
    /// at which boughs break.
    glm::dvec3 moment{0.0};
    /// Moment at which a bough tears off or, at the foot (unit 0), the tree falls, N m; 0: unknown, or the
    /// unit continues its branch.
    double limit = 0.0;
    /// Strain of the outermost wood per moment, 1/(N m); that of the trunk's first unit is at breast height.
    double strain = 0.0;
    glm::vec3 tilt{0.0f}; ///< Direction of the unit, a unit vector, minus that at rest.
};

} // namespace osgTreeWind
