// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/BranchParameters.h>

#include <osgTreeWind/motion/Laws.h>

namespace osgTreeWind {

BranchParameters makeBranchParameters(const BranchUnit& unit, const TreeScale& scale,
                                      const Species& species) {
    BranchParameters branch;
    branch.length = glm::length(scale.axes * (unit.tip - unit.base));
    const float diameter = (unit.baseRadius + unit.tipRadius) * scale.radius;
    branch.spring = Laws().cantileverSpring(species.wood.elasticModulus, diameter, diameter, branch.length);
    branch.maxAngle = species.branch.maxAngle;
    branch.partialSteps = species.branch.partialSteps;
    branch.levelLoad = species.branch.levelFactor * static_cast<float>(unit.level);
    return branch;
}

} // namespace osgTreeWind
