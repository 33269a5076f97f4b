// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

namespace osgTreeWind {

/// M(unit) = M(parent) * T(base) * R(unit) * T(-base) (thesis §3.1.3), of one unit.
UnitPose carriedPose(const UnitPose& parent, const glm::quat& rotation, const glm::vec3& base);

/// Composes M(unit) down the hierarchy, with `rotations` the turn of each unit about its own base in the
/// tree's rest axes.
/// @param rotations, poses skeleton.units.size() elements each.
void composePoses(const Skeleton& skeleton, const TreeScale& scale, const glm::quat* rotations,
                  UnitPose* poses);

/// The turn of a unit from its angles about its own two axes (law `modal`).
glm::quat swungRotation(const BranchUnit& unit, const TreeScale& scale, const glm::vec2& angles);

/// The same from the angles of each unit about its own two axes (law `modal`), with the
/// rotations on the way.
void swingPoses(const Skeleton& skeleton, const TreeScale& scale, const glm::vec2* angles,
                glm::quat* rotations, UnitPose* poses);

} // namespace osgTreeWind
