// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/UnitPose.h>

#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>

namespace osgTreeWind {

UnitPose childPose(const UnitPose& parent, const glm::quat& rotation, const glm::vec3& base) {
    UnitPose pose;
    pose.rotation = parent.rotation * rotation;
    pose.translation = parent.apply(base) - pose.rotation * base;
    return pose;
}

glm::quat swungRotation(const BranchUnit& unit, const TreeScale& scale, const glm::vec2& angles) {
    return swungRotation(angles, ScaledUnit(unit, scale).direction());
}

void composePoses(const Skeleton& skeleton, const TreeScale& scale, const glm::quat* rotations,
                  UnitPose* poses) {
    const UnitPose ground;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const UnitPose& parent = unit.parent < 0 ? ground : poses[unit.parent];
        poses[i] = childPose(parent, rotations[i], scale.axes * unit.base);
    }
}

} // namespace osgTreeWind
