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

/// One tree: placed by its position and attitude, drawn from shared buffers, moved by its forest. In full,
/// its bark is drawn below BranchTransforms and each leaf cluster below a MatrixTransform of its branch.
///
/// Any branch can be had as a BranchTransform to hang nodes on. Transforms are made when first asked for, or
/// first looked at, and turned for cameras and picking that look: a tree far away, or out of sight, costs
/// none of that.
class TreeNode : public osg::PositionAttitudeTransform {
public:
    /// Draws nothing.
    TreeNode();
    /// A tree at rest.
    TreeNode(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale);
    /// A tree of the same model, size and place, at rest; nodes hung on branches are not copied.
    TreeNode(const TreeNode& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeNode)

        /// Units of this tree; 0 for an empty one.
        unsigned getNumBranches() const;
    /// The transform of a unit (access order), in the current pose; null beyond getNumBranches(). It follows
    /// the tree from then on, seen or not; what hangs on it is drawn with the level FULL. Call it where the
    /// scene may be changed (update or event traversal, between frames).
    BranchTransform* getBranch(unsigned unit);
    /// Takes off what hangs on a branch that was asked for, which from then on follows as others do.
    /// @return false where it was not asked for.
    bool letGo(unsigned unit);

    /// Levels of detail; null for an empty one.
    TreeLod* getLod() const { return _lod.get(); }

    /// The tree as it stands; null for an empty one.
    PosedTree* getPosedTree() const { return _tree.get(); }

    /// Where the shaders find this tree: first texels of its units and leaves. Negative: at rest.
    void setTexels(int firstUnit, int firstLeaf);

    /// A number in [0, 1) that is this tree's own: leaves have a shade after it.
    void setOwnNumber(float number);

    /// Share of its leaves that the tree bears, [0, 1]; bare twigs are drawn where it has none. Not during a
    /// traversal.
    void setLeaves(float share);

    /// What is drawn at the level BILLBOARD.
    void setBillboard(osg::Drawable* picture);

    /// Takes over the pose of getPosedTree(): bounds if it `moved`, and transforms that are looked at or were
    /// asked for. In update.
    void updatePose(bool moved = true);

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~TreeNode() override = default;

private:
    struct Branch {
        osg::ref_ptr<BranchTransform> transform;
        bool asked = false;    ///< For, by getBranch().
        unsigned followed = 0; ///< It and those that it carries, as far as they were asked for.
    };
    void build(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale);
    BranchTransform* branch(unsigned unit);
    int parentOf(int unit) const;
    bool isOwn(const osg::Node* child) const;
    void makeTransforms();
    void showLeaves();
    void turnBranches(bool all);
    void turnLeaves();
    void bringUpToDate();

    osg::ref_ptr<TreeBuffers> _buffers;
    TreeStyle _style;
    osg::ref_ptr<PosedTree> _tree;
    osg::ref_ptr<TreeLod> _lod;
    osg::ref_ptr<osg::Drawable> _skin, _leaves, _bareSkin;
    std::vector<Branch> _branches;                                   ///< By unit; null those not needed yet.
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _leafTransforms; ///< Empty until they are looked at.
    float _leafShare = 1.0f;
    bool _full = false; ///< Whether the transforms of FULL are there.
};

} // namespace osgTreeWind
