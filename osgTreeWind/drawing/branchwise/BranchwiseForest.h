// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/drawing/ForestDrawing.h>
#include <osgTreeWind/drawing/branchwise/TreeLodRanges.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

class AnglePrePass;
class DataTexture;
class FloatTargetProbe;
class ImpostorStrip;
class PosedTree;
class SharedStateSet;
class TreeBuffers;
class TreeNode;
enum class Tier;
struct ForestDescription;
struct PlacedTree;
struct TreeStyle;

/// Trees drawn as the thesis published it: each branch below a BranchTransform of its own (§3.1.3), each leaf
/// cluster below a transform over one shared drawable (§2.4.1).
class OSGTREEWIND_EXPORT BranchwiseForest : public ForestDrawing {
public:
    /// Where the angles of branches and leaves are worked out.
    enum AngleSource {
        CPU_ANGLES, ///< In the update traversal: the frame shows the wind of the same frame.
        GPU_ANGLES  ///< In fragment shaders before the frame is drawn (thesis §5.2). Branch angles are read
                    ///< back and move the branches one frame later; leaves show them at once. Falls back to
                    ///< CPU_ANGLES, with one notice, where float targets or vertex textures are missing.
    };

    /// Why a forest of the description has no room in textures, which nothing may rescale; empty where it
    /// has. @param description for which check() finds nothing.
    static std::string problemOf(const ForestDescription& description);

    /// No trees.
    BranchwiseForest();
    /// @param simulation its trees, as they stand now; of null or under the law `modal` none, with a warning.
    explicit BranchwiseForest(std::shared_ptr<ForestSimulation> simulation);
    /// A copy of a part of a scene that is moved by a Forest: of the same trees, which the original moves.
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

    unsigned getNumTrees() const { return static_cast<unsigned>(_trees.size()); } ///< As many as were given.
    osg::Node* getTree(unsigned index) const; ///< What draws one, in their order; null: none.

    osg::ref_ptr<ForestDrawing> again(std::shared_ptr<ForestSimulation> simulation) const override;
    void takeSettings(const ForestDrawing& former) override;
    void update(const osg::FrameStamp& stamp) override;
    void treeChanged(std::size_t) override {} // never: its trees are those it was made with
    void speciesAdded() override {}           // nor this
    void seasonChanged() override;
    BranchTransform* follow(TreeId tree, unsigned unit) override;
    bool unfollow(TreeId tree, unsigned unit) override;

    void traverse(osg::NodeVisitor& visitor) override;                 ///< osg::Node.
    void resizeGLObjectBuffers(unsigned maxSize) override;             ///< osg::Node.
    void releaseGLObjects(osg::State* state = nullptr) const override; ///< osg::Node.

protected:
    ~BranchwiseForest() override;

private:
    friend struct BranchwiseParts;
    struct Pictures {
        osg::ref_ptr<ImpostorStrip> strip;
        osg::ref_ptr<SharedStateSet> state;
    };
    osg::ref_ptr<osg::Drawable> billboard(const PlacedTree& tree, PosedTree& posed);
    void showSeason();
    void startPasses();
    void chooseAngleSource();
    bool stepOnCpu(double time);
    bool stepOnGpu(double time);
    void uploadUnitPoses();
    void useCpuAngles();

    std::shared_ptr<ForestSimulation> _simulation;
    std::vector<osg::ref_ptr<TreeBuffers>> _buffers;            ///< By model.
    std::map<std::pair<std::size_t, Tier>, Pictures> _pictures; ///< By model and share of leaves.
    std::vector<TreeStyle> _styles;                             ///< By species.
    osg::ref_ptr<osg::Group> _stand;                            ///< The trees, and the textures they share.
    std::vector<osg::ref_ptr<TreeNode>> _trees;
    std::unique_ptr<DataTexture> _unitPoses, _leafAngles;
    // No children: in a scene they would keep everything above them from being culled.
    std::unique_ptr<AnglePrePass> _prePass;
    osg::ref_ptr<FloatTargetProbe> _probe;
    AngleSource _wantedSource = GPU_ANGLES;
    TreeLodRanges _lodRanges;
};

} // namespace osgTreeWind
