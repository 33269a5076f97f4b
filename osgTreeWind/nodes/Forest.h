// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/branchwise/BranchwiseForest.h>

#include <osg/FrameStamp>
#include <osg/Group>

#include <memory>
#include <mutex>

namespace osgTreeWind {

/// A forest moving in a given wind. Add it to a scene, hand it the wind, and let a viewer run.
///
/// The update traversal moves it on, once per frame number however many views, to the frame stamp's
/// simulation time; a paused time holds the trees. Other nodes may be its children too.
class Forest : public osg::Group {
public:
    Forest();
    explicit Forest(ForestDescription description);
    /// A forest of the same description at rest, in the wind `other` has now. Other children go by `copyop`.
    Forest(const Forest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, Forest)

        /// Replaces all trees, and the wind if the description has one; without one the wind that is set goes
        /// on. A forest for which there is not the memory (problemOfMemory()) is left empty, with a warning.
        /// Not during a traversal.
        void setDescription(ForestDescription description);
    /// Its wind is the one it came with, whatever setWind() did since.
    const ForestDescription& getDescription() const { return _simulation->description(); }

    /// The wind from the next frame on; null for calm. Any thread, any time, also while a description is set:
    /// whichever of the two comes last counts.
    void setWind(WindFieldPtr wind);
    WindFieldPtr getWind() const;

    /// World coordinates of the node's own origin: geometry is relative to it, so that it keeps its precision
    /// far from the world's origin.
    osg::Vec3d getOrigin() const;

    /// Whether a child is a part of the forest; all others are yours.
    bool isOwnChild(const osg::Node* child) const;

    unsigned getNumTrees() const { return static_cast<unsigned>(_simulation->trees().size()); }
    /// The trees drawn branch by branch: a node a tree, its transforms and passes.
    BranchwiseForest* getBranchwise() const { return _branchwise.get(); }

    /// Wind, angles and poses behind the picture. Read it between frames.
    const ForestSimulation& getSimulation() const { return *_simulation; }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~Forest() override;

private:
    void update(const osg::FrameStamp& stamp);

    mutable std::mutex _windMutex; ///< Guards _wind.
    WindFieldPtr _wind;
    std::shared_ptr<ForestSimulation> _simulation;
    osg::ref_ptr<BranchwiseForest> _branchwise;
    unsigned _lastFrame = ~0u;
};

} // namespace osgTreeWind
