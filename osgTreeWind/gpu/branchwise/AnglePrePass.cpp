// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AnglePrePass.h>

#include <osgTreeWind/gpu/branchwise/LawTexels.h>

namespace osgTreeWind {

AnglePrePass::AnglePrePass(const ForestSimulation& simulation)
    : _node(new OncePerFrame), _branchReadback(new AngleReadback), _leafReadback(new AngleReadback),
      _branches("branchwise/branch_angles", simulation.branches()->states(), _branchReadback),
      _leaves("branchwise/leaf_angles", simulation.leaves().states(), _leafReadback),
      _wind("wind", 2 * simulation.forest().units),
      _branchParameters("branch parameters", 3 * simulation.forest().units),
      _leafParameters("leaf parameters", simulation.forest().leaves),
      _species("species", speciesTexels(simulation.description(), 0.0).size()),
      _seconds(new osg::Uniform("seconds", 0.0f)) {
    _branchParameters.fill(branchTexels(simulation.forest(), *simulation.branches()));
    _leafParameters.fill(leafTexels(simulation.forest()));

    bindData(_branches.inputs(), "wind", 1, _wind.texture());
    bindData(_branches.inputs(), "branchParameters", 2, _branchParameters.texture());
    bindData(_branches.inputs(), "speciesTexels", 3, _species.texture());
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(simulation.description().law)));
    _branches.inputs().addUniform(_seconds);
    bindData(_leaves.inputs(), "leafParameters", 1, _leafParameters.texture());
    bindData(_leaves.inputs(), "speciesTexels", 2, _species.texture());

    _node->setName("angle passes");
    _node->addChild(_branches.node());
    _node->addChild(_leaves.node());
}

void AnglePrePass::step(const ForestSimulation& simulation, double time, float seconds) {
    _wind.fill(simulation.branches()->windTexels());
    _species.fill(speciesTexels(simulation.description(), time));
    _seconds->set(seconds);
    _branches.step();
    _leaves.step();
}

void AnglePrePass::hold() {
    _branches.hold();
    _leaves.hold();
}

bool AnglePrePass::readBack(ForestSimulation& simulation) {
    if (_leafReadback->take(_states)) {
        _leaves.startFrom(_states);
        simulation.leaves().setStates(_states.data());
    }
    if (!_branchReadback->take(_states))
        return false;
    _branches.startFrom(_states);
    simulation.branches()->setStates(_states.data());
    return true;
}

} // namespace osgTreeWind
