// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/Species.h>

namespace osgTreeWind {

/// What one branch unit of one tree is to the laws `thesis` and `thesis-smooth` (§3.1).
struct BranchParameters {
    float spring = 0.0f;       ///< k = E w t^3 / (4 span^3), N/m; w = t = mean diameter of the scaled unit.
    float length = 0.0f;       ///< Base to tip of the scaled unit, metres.
    float maxAngle = 0.0f;     ///< Radians.
    float partialSteps = 1.0f; ///< `NUMB`.
    float levelLoad = 0.0f;    ///< `factor` times `branchLevel`.
};

BranchParameters makeBranchParameters(const BranchUnit& unit, const TreeScale& scale, const Species& species);

} // namespace osgTreeWind
