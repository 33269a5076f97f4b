// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// Where a branch unit stands: a rest point p of the scaled tree is drawn at rotation * p + translation,
/// in the tree's own frame (metres, Z up).
struct UnitPose {
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< About the origin,
    glm::vec3 translation{0.0f};                ///< and then this far, metres.

    glm::vec3 apply(const glm::vec3& p) const {
        return rotation * p + translation;
    } ///< Where a point at rest is now.
};

/// M(unit) = M(parent) * T(base) * R(unit) * T(-base) (thesis §3.1.3), of one unit.
UnitPose carriedPose(const UnitPose& parent, const glm::quat& rotation, const glm::vec3& base);

/// Composes M(unit) down the hierarchy, with `rotations` the turn of each unit about its own base in the
/// tree's rest axes.
/// @param rotations, poses skeleton.units.size() elements each.
void composePoses(const Skeleton& skeleton, const TreeScale& scale, const glm::quat* rotations,
                  UnitPose* poses);

/// The turn of a unit from its angles about its own two axes (laws `damped` and `modal`).
glm::quat swungRotation(const BranchUnit& unit, const TreeScale& scale, const glm::vec2& angles);

/// The same from the angles of each unit about its own two axes (laws `damped` and `modal`), with the
/// rotations on the way.
void swingPoses(const Skeleton& skeleton, const TreeScale& scale, const glm::vec2* angles,
                glm::quat* rotations, UnitPose* poses);

} // namespace osgTreeWind
