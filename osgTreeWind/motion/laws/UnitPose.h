// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

namespace osgTreeWind {

/// Pose of one unit: M(unit) = M(parent) * T(base) * R(unit) * T(-base) (thesis §3.1.3).
UnitPose childPose(const UnitPose& parent, const glm::quat& rotation, const glm::vec3& base);

/// Composes the poses down the hierarchy. @param rotations of each unit about its base, in the tree's rest
/// axes.
/// @param rotations, poses skeleton.units.size() elements each.
void composePoses(const Skeleton& skeleton, const TreeScale& scale, const glm::quat* rotations,
                  UnitPose* poses);

/// Rotation of a unit from the angles about its two axes (law `modal`).
glm::quat swungRotation(const BranchUnit& unit, const TreeScale& scale, const glm::vec2& angles);

} // namespace osgTreeWind
