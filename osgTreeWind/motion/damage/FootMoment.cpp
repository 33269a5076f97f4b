// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FootMoment.h>

#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

FootMoment::FootMoment(const SwayingTree& tree)
    : _stiffness(makeUnitLoads(*tree.model, tree.scale, *tree.species, tree.leaves)[_unit].stiffness) {}

double FootMoment::of(const ModalMotion& motion, std::size_t tree) const {
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    motion.poseVector(tree, vector);
    return _stiffness * static_cast<double>(glm::length(motion.unitAngles(tree, _unit, vector)));
}

} // namespace osgTreeWind
