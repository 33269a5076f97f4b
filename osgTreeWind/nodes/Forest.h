// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/TreeNode.h>

#include <osg/FrameStamp>
#include <osg/Group>

#include <memory>
#include <vector>

namespace osgTreeWind {

class DataTexture;

/// A forest moving in a given wind. Add it to a scene, hand it the wind, and let a viewer run.
///
/// The update traversal moves it on, once per frame number however many views, to the frame stamp's
/// simulation time; a paused time holds the trees. Its children are its trees, and nodes you add.
class Forest : public osg::Group {
public:
    /// How poses reach the picture.
    enum PoseMode {
        CPU_POSE,        ///< Poses are composed on the CPU and uploaded; two draws a tree.
        SCENE_GRAPH_POSE ///< Every branch is a BranchTransform with its own bark (the thesis' way).
    };

    Forest();
    explicit Forest(ForestDescription description);
    /// A forest of the same description at rest, in the wind `other` has now. Other children go by `copyop`.
    Forest(const Forest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, Forest)

        /// Replaces all trees. Not during a traversal.
        void setDescription(ForestDescription description);
    const ForestDescription& getDescription() const { return _simulation->description(); }

    /// The wind from the next frame on; null for calm. Any thread, any time.
    void setWind(WindFieldPtr wind) { _simulation->setWind(std::move(wind)); }
    WindFieldPtr getWind() const { return _simulation->wind(); }

    /// Not during a traversal.
    void setPoseMode(PoseMode mode);
    PoseMode getPoseMode() const { return _poseMode; }

    /// World coordinates of the node's own origin: geometry is relative to it, so that it keeps its precision
    /// far from the world's origin.
    osg::Vec3d getOrigin() const;

    unsigned getNumTrees() const { return static_cast<unsigned>(_trees.size()); }
    TreeNode* getTree(unsigned index) const { return _trees[index].get(); }

    /// Wind, angles and poses behind the picture. Read it between frames.
    const ForestSimulation& getSimulation() const { return *_simulation; }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~Forest() override;

private:
    void update(const osg::FrameStamp& stamp);
    void uploadPoses();
    void removeTrees();

    std::shared_ptr<ForestSimulation> _simulation;
    std::vector<osg::ref_ptr<TreeNode>> _trees;
    std::unique_ptr<DataTexture> _unitPoses, _leafAngles;
    PoseMode _poseMode = CPU_POSE;
    unsigned _lastFrame = ~0u;
};

} // namespace osgTreeWind
