// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/Species.h>

#include <vector>

namespace osgTreeWind {

/// What one branch unit of one tree is to the law `damped`, SI units.
struct DampedParameters {
    float stiffness = 1.0f;      ///< K of the joint at the base (jointStiffness()), N m/rad.
    float inertia = 1.0f;        ///< J, kg m^2: K over the square of its axis' own speed (swaySpeeds()).
    float damping = 0.0f;        ///< C = 2 dampingRatio sqrt(K J), N m s.
    float drag = 0.0f;           ///< Half the air's density times the sum of CdA, kg/m, up to 10 m/s.
    float lever = 0.0f;          ///< Of the drag: its speed over the joint's as the whole axis bends, metres.
    float maxAngle = 0.0f;       ///< Radians.
    float streamlining = 0.0f;   ///< Drag falls as (speed / 10)^-streamlining above 10 m/s,
    float streamlinedTo = 25.0f; ///< up to this speed, m/s.
    float windHeight = 0.0f;     ///< Of the centre of that drag above the foot of the tree, metres.
    glm::vec3 direction{0, 0, 1}; ///< Base to tip of the scaled unit, unit length, tree frame.
};

/// Parameters of every unit of a tree. Each unit moves all that it carries, at its true distance: the static
/// deflection is that of the bent wood under the drag of all parts, and the frequency that of the first mode
/// of its axis with everything upon it (docs/validation.md has the derivation). Leaves are shared out by the
/// pipe model: a unit bears leaf area as its cross-section exceeds its branches'.
/// @param leaves share of its leaves that the tree bears, [0, 1].
std::vector<DampedParameters> makeDampedParameters(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species, float leaves = 1.0f);

/// The same with an answer `gain` times as large: same frequency, same damping, more torque.
DampedParameters exaggerated(DampedParameters parameters, float gain);

} // namespace osgTreeWind
