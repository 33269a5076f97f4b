// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/stand/TreeStand.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/FollowedBranches.h>

#include <osg/Group>

#include <memory>

namespace osgTreeWind {

/// A forest moving in a given wind. Add it to a scene, hand it the wind, and let a viewer run.
///
/// The update traversal moves it on, once per frame number however many views, to the frame stamp's
/// simulation time; a paused time holds the trees, and one below a Switch that is off rests. Under the law
/// `modal` trees are instances (TreeStand); a law of a branch has them drawn the thesis' way
/// (BranchwiseForest). Other nodes may be its children too. Below a transform it gets the wind of where it
/// really stands; with two parents, that of the first one.
class OSGTREEWIND_EXPORT Forest : public osg::Group {
public:
    Forest();
    explicit Forest(ForestDescription description);
    /// The same trees as they are now, at rest, in the wind `other` has; shares what does not change. Other
    /// children go by `copyop`; branches that are followed are not copied.
    Forest(const Forest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, Forest)

        /// Replaces all trees, and the wind if the description has one; without one the wind that is set goes
        /// on. A forest for which there is not the memory (problemOfMemory()) is left empty, with a warning.
        /// Not during a traversal.
        void setDescription(ForestDescription description);
    /// As given, but without its trees; its wind is the one it came with, whatever setWind() did since, and
    /// so its season.
    const ForestDescription& getDescription() const { return _simulation->description(); }

    /// The wind from the next frame on; null for calm. World coordinates less getOrigin(). Any thread, any
    /// time, also while a description is set: whichever of the two comes last counts.
    void setWind(WindFieldPtr wind);
    WindFieldPtr getWind() const;

    /// A host's threads to step and grow it, SimulationOptions says more; null: those of the process. For the
    /// trees that it has now from the next step on, and for descriptions to come. In update or between
    /// frames.
    void setExecutor(Executor executor);

    /// Of the year (species/Season.h): leaves, their colour, and what they do to how trees sway. In update or
    /// between frames.
    void setSeason(float season);
    float getSeason() const { return _simulation->season(); }

    /// World coordinates of the node's own origin: geometry is relative to it, so that it keeps its precision
    /// far from the world's origin.
    osg::Vec3d getOrigin() const;

    // Trees that come and go, in update or between frames, at a cost that does not depend on how many there
    // are (ForestSimulation says more). Under the law `modal` only: elsewhere it is a problem.

    /// @param placement in world coordinates. @return an id that lasts.
    Result<TreeId> addTree(const TreePlacement& placement);
    /// @return the problems; empty when it is done.
    Diagnostics removeTree(TreeId tree);
    /// Moves it, or makes it one of another size or species, in full sway.
    /// @return the problems; empty when it is done.
    Diagnostics changeTree(TreeId tree, const TreePlacement& placement);
    /// By the name it has in an inventory; noTree for none.
    TreeId findTree(const std::string& name) const;
    /// Trees there are now.
    std::size_t getNumTrees() const { return _treeCount; }

    /// A transform that goes where a branch goes, in the same frame: what is below it stands in the
    /// coordinates of its tree at rest, in metres. The same one for the same branch; null where there is
    /// none. It stays where it was when its tree is removed. In update or between frames.
    BranchTransform* branch(TreeId tree, unsigned unit);

    /// Puts state after that of a species' bark or leaves (index into the description's); null takes it away.
    /// One with a program of its own replaces ours: it finds a tree's `treePlace`, `treeSize` and `treeState`
    /// at the attribute locations 12, 13 and 14 (shaders/instance.glsl). Under `modal`; not during a
    /// traversal.
    void setBarkState(std::size_t species, osg::StateSet* state);
    void setLeafState(std::size_t species, osg::StateSet* state);
    /// Draws the trees of a model (index into getSimulation().models()) from these, at every tier with
    /// branches, null for none: geometry with buffer objects and the arrays of shaders/instance_bark.vert and
    /// instance_leaf.vert, the index of the unit that moves a vertex among them. Under `modal`; not during a
    /// traversal.
    void setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves);

    /// Whether a child is a part of the forest; all others are yours.
    bool isOwnChild(const osg::Node* child) const;

    /// The trees as instances; null under a law of a branch.
    TreeStand* getStand() const { return _stand.get(); }
    /// The trees drawn branch by branch: a node a tree, its transforms and passes; null under `modal`.
    BranchwiseForest* getBranchwise() const { return _branchwise.get(); }

    /// Wind, angles and poses behind the picture. Read it between frames.
    const ForestSimulation& getSimulation() const { return *_simulation; }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~Forest() override;

private:
    /// @param drawing to share; null: its own.
    void show(std::shared_ptr<ForestSimulation> simulation, const StandResources* drawing = nullptr);
    void update(osg::NodeVisitor& visitor);
    bool isHidden(const osg::NodePath& path, unsigned frame) const;
    void stand(const osg::NodePath& path);

    std::shared_ptr<GivenWind> _wind; ///< Of `_simulation` too.
    Executor _executor;
    std::shared_ptr<ForestSimulation> _simulation;
    osg::ref_ptr<TreeStand> _stand;
    osg::ref_ptr<BranchwiseForest> _branchwise;
    osg::ref_ptr<FollowedBranches> _followed;
    std::size_t _treeCount = 0;
    unsigned _lastFrame = ~0u;
    std::atomic<unsigned> _culledFrame{~0u};
    osg::Matrix _place; ///< To the scene's root, in the last update.
    bool _twoPlaces = false;
};

} // namespace osgTreeWind
