// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/DataTexture.h>

#include <osg/Camera>
#include <osg/Group>

#include <vector>

namespace osgTreeWind {

/// A pre-render pass that works out the next state of every element from the one before: one quad whose
/// fragments are the elements (thesis §5.2). The states go back and forth between two textures. Changed in
/// update only.
class AnglePass {
public:
    /// @param shader fragment shader, e.g. "branchwise/branch_angles". @param states to start from.
    AnglePass(const char* shader, const std::vector<glm::vec4>& states);

    /// State of the pass: bind its inputs here, from texture unit 1 on; unit 0 holds the states before.
    osg::StateSet& inputs() { return *_node->getStateSet(); }
    /// To be put into the scene, below a OncePerFrame.
    osg::Node* node() const { return _node.get(); }

    /// The next frame draws the pass, from the states that this one ends with.
    void step();
    /// The next frame draws nothing: the states stay.
    void hold();

    /// Where the states stand once the frame being prepared has drawn the pass.
    osg::Texture2D* states() const { return _textures[_latest].texture(); }

    /// Has a context that comes later, or one that was lost, start from these states.
    /// @param texels of states(), as many as there are at most.
    void startFrom(const std::vector<glm::vec4>& texels);

    /// Called in the draw thread after each drawing of the pass.
    void setPostDrawCallback(osg::Camera::DrawCallback* callback);

private:
    osg::ref_ptr<osg::Group> _node;
    DataTexture _textures[2];
    osg::ref_ptr<osg::Camera> _cameras[2]; ///< i draws into texture i from the other one.
    int _latest = 0;
};

} // namespace osgTreeWind
