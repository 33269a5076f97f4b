// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/DataTexture.h>

#include <osg/Camera>

#include <vector>

namespace osgTreeWind {

/// A pre-render pass that computes the next state of each element from its previous state: one quad with a
/// fragment per element (thesis §5.2). It draws into a second texture and copies the result back into
/// states(), so that frames without a draw keep the states. It also copies them to the CPU: the update of
/// frame N reads the states of frame N - 1. Changed in update only.
class AnglePass {
public:
    /// @param shader fragment shader, e.g. "branchwise/branch_angles". @param states initial states.
    AnglePass(const char* shader, const std::vector<glm::vec4>& states);
    ~AnglePass();

    /// Bind the inputs of the pass here, from texture unit 1 on; unit 0 has the previous states.
    osg::StateSet& inputs() { return *_camera->getStateSet(); }
    /// The camera of the pass, to be culled once per frame.
    osg::Node* node() const { return _camera.get(); }

    /// Makes the next frame draw the pass.
    void step() { _camera->setNodeMask(~0u); }
    /// Makes the next frame keep the states.
    void hold() { _camera->setNodeMask(0); }

    osg::Texture2D* states() const { return _states.texture(); }

    /// Reads the states of the last drawn frame. New and lost contexts will start from them.
    /// @param texels receives all texels of states(), including padding.
    /// @return false if they were read before.
    bool readBack(std::vector<glm::vec4>& texels);

private:
    class Quad;

    DataTexture _states, _target;
    osg::ref_ptr<Quad> _quad;
    osg::ref_ptr<osg::Camera> _camera;
};

} // namespace osgTreeWind
