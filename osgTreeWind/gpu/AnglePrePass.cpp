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

void bind(osg::StateSet& state, const char* sampler, int unit, const DataTexture& texture) {
    // Protected, since a shadow technique, say, overrides textures of the scene above.
    state.setTextureAttribute(static_cast<unsigned>(unit), texture.texture(),
                              osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED);
    state.addUniform(new osg::Uniform(sampler, unit));
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

    bind(_branches.inputs(), "wind", 1, _wind);
    bind(_branches.inputs(), "branchParameters", 2, _branchParameters);
    bind(_branches.inputs(), "speciesTexels", 3, _species);
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(simulation.description().law)));
    _branches.inputs().addUniform(_seconds);
    _branches.setPostDrawCallback(_branchReadback);
    bind(_leaves.inputs(), "leafParameters", 1, _leafParameters);
    bind(_leaves.inputs(), "speciesTexels", 2, _species);

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
