// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/Species.h>

#include <vector>

namespace osgTreeWind {

/// What one branch unit of one tree is to the law `damped`, SI units.
struct DampedParameters {
    float stiffness = 1.0f;       ///< K = k L^2 of a tapered round cantilever, N m/rad.
    float inertia = 1.0f;         ///< J about the base, kg m^2, with what the unit carries at its tip.
    float damping = 0.0f;         ///< C = 2 dampingRatio sqrt(K J), N m s.
    float drag = 0.0f;            ///< Half the air's density times the sum of CdA, kg/m.
    float lever = 0.0f;           ///< Of the drag about the base, metres.
    float maxAngle = 0.0f;        ///< Radians.
    glm::vec3 direction{0, 0, 1}; ///< Base to tip of the scaled unit, unit length, tree frame.
};

/// Parameters of every unit of a tree. A unit carries the mass and the drag of all units above it at its tip.
/// Drag area and lever are those that give the torque and the damping of the parts together.
std::vector<DampedParameters> makeDampedParameters(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species);

} // namespace osgTreeWind
