// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AnglePrePass.h>

#include <osgTreeWind/gpu/branchwise/LawTexels.h>

namespace osgTreeWind {

AnglePrePass::AnglePrePass(const BranchwiseMotion& motion)
    : _node(new OncePerFrame), _branches("branchwise/branch_angles", motion.states()),
      _leaves("branchwise/leaf_angles", motion.leafStates()), _wind("wind", motion.forest().units),
      _branchParameters("branch parameters", 3 * motion.forest().units),
      _leafParameters("leaf parameters", motion.forest().leaves),
      _species("species", speciesTexels(motion.forest().description(), 0.0).size()) {
    _branchParameters.fill(branchTexels(motion.forest(), motion));
    _leafParameters.fill(leafTexels(motion.forest()));

    bindData(_branches.inputs(), "wind", 1, _wind.texture());
    bindData(_branches.inputs(), "branchParameters", 2, _branchParameters.texture());
    bindData(_branches.inputs(), "speciesTexels", 3, _species.texture());
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(motion.forest().description().law)));
    bindData(_leaves.inputs(), "leafParameters", 1, _leafParameters.texture());
    bindData(_leaves.inputs(), "speciesTexels", 2, _species.texture());

    _node->setName("angle passes");
    _node->addChild(_branches.node());
    _node->addChild(_leaves.node());
}

void AnglePrePass::step(const BranchwiseMotion& motion, double time) {
    _wind.fill(motion.windTexels());
    _species.fill(speciesTexels(motion.forest().description(), time));
    _branches.step();
    _leaves.step();
}

void AnglePrePass::hold() {
    _branches.hold();
    _leaves.hold();
}

bool AnglePrePass::readBack(BranchwiseMotion& motion) {
    if (_leaves.take(_states))
        motion.setLeafStates(_states);
    if (!_branches.take(_states))
        return false;
    motion.setStates(_states);
    return true;
}

} // namespace osgTreeWind
