// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/UnitPose.h>

#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>

namespace osgTreeWind {

void composePoses(const Skeleton& skeleton, const TreeScale& scale, const glm::quat* rotations,
                  UnitPose* poses) {
    const UnitPose ground;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const UnitPose& parent = unit.parent < 0 ? ground : poses[unit.parent];
        const glm::vec3 base = scale.axes * unit.base;
        poses[i].rotation = parent.rotation * rotations[i];
        poses[i].translation = parent.apply(base) - poses[i].rotation * base;
    }
}

void swingPoses(const Skeleton& skeleton, const TreeScale& scale, const glm::vec2* angles,
                glm::quat* rotations, UnitPose* poses) {
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        rotations[i] = dampedRotation(glm::vec4(angles[i], 0.0f, 0.0f),
                                      ScaledUnit(skeleton.units[i], scale).direction());
    composePoses(skeleton, scale, rotations, poses);
}

} // namespace osgTreeWind
