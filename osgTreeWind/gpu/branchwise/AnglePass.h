// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/DataTexture.h>

#include <osg/Camera>

#include <vector>

namespace osgTreeWind {

/// A pre-render pass that works out the next state of every element from the one before: one quad whose
/// fragments are the elements (thesis §5.2). It is drawn into a second texture, and its own draw puts the
/// result back into states(): what no context draws leaves them as they are. It also copies them to the CPU,
/// stamped with the frame, so that update of frame N takes the states of frame N - 1. Changed in update only.
class AnglePass {
public:
    /// @param shader fragment shader, e.g. "branchwise/branch_angles". @param states to start from.
    AnglePass(const char* shader, const std::vector<glm::vec4>& states);
    ~AnglePass();

    /// State of the pass: bind its inputs here, from texture unit 1 on; unit 0 holds the states before.
    osg::StateSet& inputs() { return *_camera->getStateSet(); }
    /// To be culled once a frame.
    osg::Node* node() const { return _camera.get(); }

    /// The next frame draws the pass.
    void step() { _camera->setNodeMask(~0u); }
    /// The next frame draws nothing: the states stay.
    void hold() { _camera->setNodeMask(0); }

    osg::Texture2D* states() const { return _states.texture(); }

    /// The states of the frame drawn last, unless they were taken before; a context that comes later, or one
    /// that was lost, starts from them. @param texels become all texels of states(), padding included.
    /// @return whether there were any.
    bool take(std::vector<glm::vec4>& texels);

private:
    class Quad;

    DataTexture _states, _target;
    osg::ref_ptr<Quad> _quad;
    osg::ref_ptr<osg::Camera> _camera;
};

} // namespace osgTreeWind
