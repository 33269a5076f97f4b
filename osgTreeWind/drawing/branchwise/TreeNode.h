// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/drawing/branchwise/PosedTree.h>
#include <osgTreeWind/drawing/branchwise/TreeBuffers.h>
#include <osgTreeWind/drawing/branchwise/TreeLod.h>
#include <osgTreeWind/drawing/branchwise/TreeStyle.h>

#include <osg/PositionAttitudeTransform>

#include <vector>

namespace osgTreeWind {

/// The node of one tree, drawn from shared buffers and moved by its forest. In full detail, its bark is below
/// BranchTransforms and each leaf cluster below a MatrixTransform of its branch.
///
/// getBranch() gives transforms to attach nodes to. Transforms are created for the first getBranch(), camera
/// or picking visitor that needs them, and updated only for those.
class TreeNode : public osg::PositionAttitudeTransform {
public:
    /// An empty node without a tree.
    TreeNode();
    /// A tree at rest.
    TreeNode(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale);
    /// A tree of the same model, size and place, at rest, without the nodes attached to its branches.
    TreeNode(const TreeNode& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeNode)

    /// Number of branch units; 0 without a tree.
    unsigned getNumBranches() const;
    /// The transform of a unit (access order) in the current pose; null if there is no such unit. From now on
    /// it follows the tree even if no camera sees it. Its children are drawn with the level FULL. Call it in
    /// the update or event traversal or between frames.
    BranchTransform* getBranch(unsigned unit);
    /// Removes what the host attached to a branch, which then moves only while a camera sees it.
    /// @return false if getBranch() was not called for it.
    bool releaseBranch(unsigned unit);

    /// Null without a tree.
    TreeLod* getLod() const { return _lod.get(); }

    /// Null without a tree.
    PosedTree* getPosedTree() const { return _tree.get(); }

    /// Sets the first texels of the tree's units and leaves in the textures of poses. Negative: at rest.
    void setTexels(int firstUnit, int firstLeaf);

    /// Sets the random number of this tree, [0, 1), which varies the shade of its leaves.
    void setTreeRandom(float number);

    /// Sets the share of leaves on the tree, [0, 1]; the other clusters are bare twigs. Not during a
    /// traversal.
    void setLeafShare(float share);

    /// Sets the drawable of the level BILLBOARD.
    void setBillboard(osg::Drawable* picture);

    /// Updates the bounds if the tree `moved`, and the transforms that cameras see or getBranch() returned,
    /// to the pose of getPosedTree(). In update.
    void updatePose(bool moved = true);

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~TreeNode() override = default;

private:
    struct Branch {
        osg::ref_ptr<BranchTransform> transform;
        bool isRequested = false; ///< By getBranch().
        unsigned requests = 0;    ///< Number of requested branches that move with it, including itself.
    };
    void build(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale);
    BranchTransform* branch(unsigned unit);
    int parentOf(int unit) const;
    bool isTreePart(const osg::Node* child) const;
    void makeTransforms();
    void updateLeafStates();
    void turnBranches(bool all);
    void turnLeaves();
    void updateFullLevel();

    osg::ref_ptr<TreeBuffers> _buffers;
    TreeStyle _style;
    osg::ref_ptr<PosedTree> _tree;
    osg::ref_ptr<TreeLod> _lod;
    osg::ref_ptr<osg::Drawable> _skin, _leaves, _bareSkin;
    std::vector<Branch> _branches;                                   ///< By unit.
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _leafTransforms; ///< By cluster; empty until needed.
    float _leafShare = 1.0f;
    bool _hasTransforms = false; ///< Whether FULL has its transforms.
};

} // namespace osgTreeWind
