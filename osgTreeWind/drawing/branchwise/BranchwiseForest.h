// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/drawing/ForestTechnique.h>
#include <osgTreeWind/drawing/branchwise/TreeLodRanges.h>

#include <memory>

namespace osgTreeWind {

class ForestAnglePasses;
class BranchwiseTrees;

/// Draws trees under a branchwise law as the thesis describes it: a BranchTransform for each branch (§3.1.3),
/// and for each leaf cluster a transform above a shared drawable (§2.4.1).
///
///     description.law = MotionLaw::Thesis;
///     forest = new Forest(description);
///     forest->getBranchwise()->setAngleSource(BranchwiseForest::CPU_ANGLES);
class OSGTREEWIND_EXPORT BranchwiseForest : public ForestTechnique {
public:
    /// Where the angles of branches and leaves are computed.
    enum AngleSource {
        CPU_ANGLES, ///< In the update traversal. A frame shows the wind of the same frame.
        GPU_ANGLES ///< In fragment shaders before the frame is drawn (thesis §5.2). Leaves show the angles at
                   ///< once; branch angles are read back and move the branches one frame later. Falls back to
                   ///< CPU_ANGLES, with one notice, without float render targets or vertex textures.
    };

    BranchwiseForest();
    /// Draws the trees of a simulation, like setSimulation().
    explicit BranchwiseForest(std::shared_ptr<ForestSimulation> simulation);
    /// A copy without trees, with the same angle source and levels of detail.
    BranchwiseForest(const BranchwiseForest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, BranchwiseForest)

    /// CPU_ANGLES takes effect in the next frame. GPU_ANGLES, the default, waits for a frame that tests the
    /// graphics context. Not during a traversal.
    void setAngleSource(AngleSource source);
    /// The angle source in use. It is GPU_ANGLES only after a graphics context was found to support it.
    AngleSource getAngleSource() const { return _prePass ? GPU_ANGLES : CPU_ANGLES; }

    /// Sets the ranges of all trees. Not during a traversal.
    /// @return a problem, with the ranges unchanged, if one is negative or not a number; else empty.
    [[nodiscard]] Diagnostics setLodRanges(const TreeLodRanges& ranges);
    const TreeLodRanges& getLodRanges() const { return _lodRanges; } ///< Ranges of all trees.

    unsigned getNumTrees() const; ///< Number of trees of the simulation.
    /// The node of a tree, in the order of the description; null beyond the last one.
    osg::Node* getTree(unsigned index) const;

    /// Draws no trees, with a warning, for null and for a simulation under the law `modal`.
    void setSimulation(std::shared_ptr<ForestSimulation> simulation) override;
    bool stepsItself() const override { return _prePass != nullptr; }
    void update(const osg::FrameStamp& stamp, bool moved) override;
    void seasonChanged() override;
    BranchTransform* branch(TreeId tree, unsigned unit) override;
    bool releaseBranch(TreeId tree, unsigned unit) override;
    BranchwiseForest* asBranchwiseForest() override { return this; }

    void traverse(osg::NodeVisitor& visitor) override;                 ///< osg::Node.
    void resizeGLObjectBuffers(unsigned maxSize) override;             ///< osg::Node.
    void releaseGLObjects(osg::State* state = nullptr) const override; ///< osg::Node.

protected:
    ~BranchwiseForest() override;

private:
    friend BranchwiseTrees& branchwiseTrees(const BranchwiseForest& forest);
    friend const ForestAnglePasses* anglePasses(const BranchwiseForest& forest);
    class FloatTargetProbe;

    void startPasses();
    void chooseAngleSource();
    bool stepOnGpu(double time, bool isDue);
    void useCpuAngles();
    void applyLodRanges();

    osg::ref_ptr<BranchwiseTrees> _trees;
    // Not children of this node: as children they would disable culling of all nodes above them.
    std::unique_ptr<ForestAnglePasses> _prePass;
    osg::ref_ptr<FloatTargetProbe> _probe;
    AngleSource _wantedSource = GPU_ANGLES;
    TreeLodRanges _lodRanges;
};

} // namespace osgTreeWind
