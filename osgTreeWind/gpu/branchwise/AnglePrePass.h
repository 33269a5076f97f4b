// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/branchwise/AnglePass.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <map>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// The thesis' division of work (§5.2, Fig 5.1) for a whole forest: the CPU samples the wind into a texture,
/// two passes work out the angles of all branches and of all leaves, and they come back for transforms and
/// picking. Used in update only.
class AnglePrePass {
public:
    /// Goes on from the states of `motion`.
    explicit AnglePrePass(const BranchwiseMotion& motion);

    /// What keeps the passes; no child of any node.
    osg::Node* node() const { return _node.get(); }
    /// With the forest. Only the first cull traversal of a frame in each context gets through: however many
    /// views, shadow passes and cameras see a scene, the passes are drawn once.
    void cull(osg::NodeVisitor& visitor);

    /// Has the next frame take a step, in the wind that SimulationParts::beginStep() sampled.
    /// @param time as of that call.
    void step(const BranchwiseMotion& motion, double time);
    /// Has the next frame keep the angles.
    void hold();

    /// Hands the states of the frame drawn last to `motion`. @return whether there were new ones.
    bool readBack(BranchwiseMotion& motion);

    /// Leaf angles, as the frame draws them.
    osg::Texture2D* leafAngles() const { return _leaves.states(); }
    /// The wind that branch angles come from.
    osg::Texture2D* wind() const { return _wind.texture(); }

private:
    osg::ref_ptr<osg::Group> _node;
    std::mutex _mutex;                       // guards _lastFrame
    std::map<unsigned, unsigned> _lastFrame; ///< By context.
    AnglePass _branches, _leaves;
    DataTexture _wind, _branchParameters, _leafParameters, _species;
    std::vector<glm::vec4> _states; ///< As read back.
};

} // namespace osgTreeWind
