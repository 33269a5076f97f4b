// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/ThesisParameters.h>

namespace osgTreeWind {

Laws::ThesisBranch makeThesisBranch(const BranchUnit& unit, const TreeScale& scale, const Species& species) {
    Laws::ThesisBranch branch;
    branch.branchLength = glm::length(scale.axes * (unit.tip - unit.base));
    const float diameter = (unit.baseRadius + unit.tipRadius) * scale.radius;
    branch.spring =
        Laws().cantileverSpring(species.wood.elasticModulus, diameter, diameter, branch.branchLength);
    branch.maxAngle = species.branch.maxAngle;
    branch.partialSteps = species.branch.partialSteps;
    branch.levelLoad = species.branch.levelFactor * static_cast<float>(unit.level);
    return branch;
}

Laws::ThesisLeaf makeThesisLeaf(const LeafMotion& motion) {
    return {motion.maxAngleX,    motion.maxAngleZ, motion.maxRotation,
            motion.partialSteps, motion.factor,    motion.linkedFactor};
}

} // namespace osgTreeWind
