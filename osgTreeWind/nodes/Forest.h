// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/TreeNode.h>

#include <osg/FrameStamp>
#include <osg/Group>

#include <memory>
#include <mutex>
#include <vector>

namespace osgTreeWind {

class AnglePrePass;
class DataTexture;
class FloatTargetProbe;

/// A forest moving in a given wind. Add it to a scene, hand it the wind, and let a viewer run.
///
/// The update traversal moves it on, once per frame number however many views, to the frame stamp's
/// simulation time; a paused time holds the trees. Other nodes may be its children too.
class Forest : public osg::Group {
public:
    /// Where the angles of branches and leaves are worked out.
    enum AngleSource {
        CPU_ANGLES, ///< In the update traversal: the frame shows the wind of the same frame.
        GPU_ANGLES  ///< In fragment shaders before the frame is drawn (thesis §5.2). Branch angles are read
                    ///< back and move the branches one frame later; leaves show them at once. Falls back to
                    ///< CPU_ANGLES, with one notice, where float targets or vertex textures are missing; and
                    ///< for the law `modal`, which has no state for each branch.
    };
    /// How branches are drawn.
    enum BranchDrawing {
        TREE_DRAWING,  ///< The bark of a tree in one draw, posed by its vertex shader.
        BRANCH_DRAWING ///< Every branch below a BranchTransform of its own (the thesis' way, §3.1.3).
    };

    /// How leaves are drawn.
    enum LeafDrawing {
        TREE_LEAVES,    ///< All of a tree in one draw, whose vertex shader fetches each cluster's angles.
        LEAF_TRANSFORMS ///< Every cluster below a transform of its own (as published, §2.4.1).
    };

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

    /// From the next frame on. Not during a traversal. A new Forest takes the environment's
    /// OSGTREEWIND_ANGLES (cpu or gpu), else CPU_ANGLES.
    void setAngleSource(AngleSource source);
    /// Where they are worked out now: GPU_ANGLES only once a context has been found to support it.
    AngleSource getAngleSource() const { return _prePass ? GPU_ANGLES : CPU_ANGLES; }

    /// Not during a traversal.
    void setBranchDrawing(BranchDrawing drawing);
    BranchDrawing getBranchDrawing() const { return _branchDrawing; }

    /// Not during a traversal.
    void setLeafDrawing(LeafDrawing drawing);
    LeafDrawing getLeafDrawing() const { return _leafDrawing; }

    /// World coordinates of the node's own origin: geometry is relative to it, so that it keeps its precision
    /// far from the world's origin.
    osg::Vec3d getOrigin() const;

    /// Whether a child is a part of the forest; all others are yours.
    bool isOwnChild(const osg::Node* child) const;

    unsigned getNumTrees() const { return static_cast<unsigned>(_trees.size()); }
    TreeNode* getTree(unsigned index) const { return _trees[index].get(); }

    /// Wind, angles and poses behind the picture. Read it between frames.
    const ForestSimulation& getSimulation() const { return *_simulation; }
    /// The passes at work; null with CPU_ANGLES.
    const AnglePrePass* getAnglePrePass() const { return _prePass.get(); }

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~Forest() override;

private:
    void show(std::shared_ptr<ForestSimulation> simulation);
    void update(const osg::FrameStamp& stamp);
    void chooseAngleSource();
    bool stepOnCpu(double time);
    bool stepOnGpu(double time);
    void uploadUnitPoses();
    void useCpuAngles();

    mutable std::mutex _windMutex; ///< Guards _wind.
    WindFieldPtr _wind;
    std::shared_ptr<ForestSimulation> _simulation;
    osg::ref_ptr<osg::Group> _stand; ///< The trees, and the textures they share.
    std::vector<osg::ref_ptr<TreeNode>> _trees;
    std::unique_ptr<DataTexture> _unitPoses, _leafAngles;
    std::unique_ptr<AnglePrePass> _prePass;
    osg::ref_ptr<FloatTargetProbe> _probe;
    AngleSource _wantedSource;
    BranchDrawing _branchDrawing = TREE_DRAWING;
    LeafDrawing _leafDrawing = TREE_LEAVES;
    unsigned _lastFrame = ~0u;
};

} // namespace osgTreeWind
