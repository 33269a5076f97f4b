// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/AnglePrePass.h>

#include <osgTreeWind/gpu/LawTexels.h>

#include <cstring>

namespace osgTreeWind {
namespace {

const float* floats(const std::vector<glm::vec4>& texels) {
    return reinterpret_cast<const float*>(texels.data());
}

void fill(DataTexture& texture, const std::vector<glm::vec4>& texels) {
    if (!texels.empty())
        std::memcpy(texture.data(), texels.data(), texels.size() * sizeof(glm::vec4));
    texture.dirty();
}

} // namespace

AnglePrePass::AnglePrePass(const ForestSimulation& simulation)
    : _node(new OncePerFrame),
      _branches("branch_angles", floats(simulation.branchStates()), simulation.branchStates().size()),
      _leaves("leaf_angles", floats(simulation.leafStates()), simulation.leafStates().size()),
      _wind("wind", simulation.branchStates().size()),
      _branchParameters("branch parameters", 3 * simulation.branchStates().size()),
      _leafParameters("leaf parameters", simulation.leafStates().size()),
      _species("species", texelsPerSpecies * simulation.description().species.size()),
      _seconds(new osg::Uniform("seconds", 0.0f)), _branchReadback(new AngleReadback) {
    fill(_branchParameters, branchTexels(simulation));
    fill(_leafParameters, leafTexels(simulation));

    bindData(_branches.inputs(), "wind", 1, _wind.texture());
    bindData(_branches.inputs(), "branchParameters", 2, _branchParameters.texture());
    bindData(_branches.inputs(), "speciesTexels", 3, _species.texture());
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(simulation.description().law)));
    _branches.inputs().addUniform(_seconds);
    _branches.setPostDrawCallback(_branchReadback);
    bindData(_leaves.inputs(), "leafParameters", 1, _leafParameters.texture());
    bindData(_leaves.inputs(), "speciesTexels", 2, _species.texture());

    _node->setName("angle passes");
    _node->addChild(_branches.node());
    _node->addChild(_leaves.node());
}

void AnglePrePass::step(const ForestSimulation& simulation, double time, float seconds) {
    simulation.localWind(reinterpret_cast<glm::vec4*>(_wind.data()));
    _wind.dirty();
    speciesTexels(simulation, time, reinterpret_cast<glm::vec4*>(_species.data()));
    _species.dirty();
    _seconds->set(seconds);
    _branches.step();
    _leaves.step();
}

void AnglePrePass::hold() {
    _branches.hold();
    _leaves.hold();
}

bool AnglePrePass::readBack(ForestSimulation& simulation, bool leavesToo) {
    unsigned frame = 0;
    if (leavesToo != _leafReadback.valid()) {
        _leafReadback = leavesToo ? new AngleReadback : nullptr;
        _leaves.setPostDrawCallback(_leafReadback);
    }
    if (_leafReadback && _leafReadback->take(_states, frame))
        simulation.setLeafStates(_states.data());
    if (!_branchReadback->take(_states, frame))
        return false;
    _branches.startFrom(floats(_states));
    simulation.setBranchStates(_states.data());
    return true;
}

} // namespace osgTreeWind
