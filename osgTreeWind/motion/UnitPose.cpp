// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/UnitPose.h>

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

} // namespace osgTreeWind
