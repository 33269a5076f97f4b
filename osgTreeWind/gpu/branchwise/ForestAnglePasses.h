// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/branchwise/AnglePass.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <map>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// The angle passes of a forest, with the thesis' division of work (§5.2, Fig 5.1): the CPU samples the wind
/// into a texture, two passes compute the angles of all branches and leaves, and the CPU reads them back for
/// transforms and picking. Used in update only, except cull().
class ForestAnglePasses {
public:
    /// Starts from the states of `motion`.
    explicit ForestAnglePasses(const BranchwiseMotion& motion);

    /// The group of the passes, without a parent.
    osg::Node* node() const { return _node.get(); }
    /// Call in each cull traversal of the forest. Only the first one of a frame in each context reaches the
    /// passes, so that they are drawn once for all views, shadow passes and cameras.
    void cull(osg::NodeVisitor& visitor);

    /// Makes the next frame take a step, in the wind that movingForest().beginStep() sampled.
    /// @param time of that call.
    void step(const BranchwiseMotion& motion, double time);
    /// Makes the next frame keep the angles.
    void hold();

    /// Copies the states of the last drawn frame to `motion`. @return whether the branches have new states.
    bool readBack(BranchwiseMotion& motion);

    /// The leaf angles that the frame draws.
    osg::Texture2D* leafAngles() const { return _leaves.states(); }
    /// The wind at the branches.
    osg::Texture2D* wind() const { return _wind.texture(); }

private:
    osg::ref_ptr<osg::Group> _node;
    std::mutex _mutex;                       ///< Guards `_lastFrame`.
    std::map<unsigned, unsigned> _lastFrame; ///< By context.
    AnglePass _branches, _leaves;
    DataTexture _wind, _branchParameters, _leafParameters, _species;
    std::vector<glm::vec4> _states; ///< Buffer for readBack().
};

} // namespace osgTreeWind
