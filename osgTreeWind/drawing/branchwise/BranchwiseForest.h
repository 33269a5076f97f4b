// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/drawing/ForestTechnique.h>
#include <osgTreeWind/drawing/branchwise/TreeLodRanges.h>

#include <memory>

namespace osgTreeWind {

class AnglePrePass;
class BranchwiseTrees;

/// Trees drawn as the thesis published it: each branch below a BranchTransform of its own (§3.1.3), each leaf
/// cluster below a transform over one shared drawable (§2.4.1).
///
///     description.law = MotionLaw::Thesis;
///     forest = new Forest(description);
///     forest->getBranchwise()->setAngleSource(BranchwiseForest::CPU_ANGLES);
class OSGTREEWIND_EXPORT BranchwiseForest : public ForestTechnique {
public:
    /// Where the angles of branches and leaves are worked out.
    enum AngleSource {
        CPU_ANGLES, ///< In the update traversal: the frame shows the wind of the same frame.
        GPU_ANGLES  ///< In fragment shaders before the frame is drawn (thesis §5.2). Branch angles are read
                    ///< back and move the branches one frame later; leaves show them at once. Falls back to
                    ///< CPU_ANGLES, with one notice, where float targets or vertex textures are missing.
    };

    /// No trees.
    BranchwiseForest();
    /// Draws the trees of a simulation, as setSimulation().
    explicit BranchwiseForest(std::shared_ptr<ForestSimulation> simulation);
    /// The same angle source and levels of detail; no trees.
    BranchwiseForest(const BranchwiseForest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, BranchwiseForest)

        /// From the next frame on; GPU_ANGLES until it is called. Not during a traversal.
        void setAngleSource(AngleSource source);
    /// Where they are worked out now: GPU_ANGLES only once a context has been found to support it.
    AngleSource getAngleSource() const { return _prePass ? GPU_ANGLES : CPU_ANGLES; }

    /// Of all trees. Not during a traversal. @return a problem, and nothing is changed, for what is not a
    /// number from 0 on; else empty.
    Diagnostics setLodRanges(const TreeLodRanges& ranges);
    const TreeLodRanges& getLodRanges() const { return _lodRanges; } ///< As set.

    unsigned getNumTrees() const;             ///< As many as were given.
    osg::Node* getTree(unsigned index) const; ///< What draws one, in their order; null: none.

    /// Draws no trees, and warns, for null or the law `modal`.
    void setSimulation(std::shared_ptr<ForestSimulation> simulation) override;
    void update(const osg::FrameStamp& stamp) override;
    void seasonChanged() override;
    BranchTransform* follow(TreeId tree, unsigned unit) override;
    bool unfollow(TreeId tree, unsigned unit) override;
    BranchwiseForest* asBranchwiseForest() override { return this; }

    void traverse(osg::NodeVisitor& visitor) override;                 ///< osg::Node.
    void resizeGLObjectBuffers(unsigned maxSize) override;             ///< osg::Node.
    void releaseGLObjects(osg::State* state = nullptr) const override; ///< osg::Node.

protected:
    ~BranchwiseForest() override;

private:
    friend struct BranchwiseParts;
    class FloatTargetProbe;

    void startPasses();
    void chooseAngleSource();
    bool stepOnCpu(double time);
    bool stepOnGpu(double time);
    void useCpuAngles();

    osg::ref_ptr<BranchwiseTrees> _trees;
    // No children: in a scene they would keep everything above them from being culled.
    std::unique_ptr<AnglePrePass> _prePass;
    osg::ref_ptr<FloatTargetProbe> _probe;
    AngleSource _wantedSource = GPU_ANGLES;
    TreeLodRanges _lodRanges;
};

} // namespace osgTreeWind
