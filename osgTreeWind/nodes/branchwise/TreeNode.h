// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/BranchTransform.h>
#include <osgTreeWind/nodes/branchwise/PosedTree.h>
#include <osgTreeWind/nodes/branchwise/TreeShape.h>
#include <osgTreeWind/nodes/branchwise/TreeStyle.h>

#include <osg/PositionAttitudeTransform>

#include <vector>

namespace osgTreeWind {

/// One tree: placed by its position and attitude, drawn from a shared shape, moved by its forest.
///
/// Any branch can be had as a BranchTransform to hang nodes on. They are made when first asked for, with the
/// branches below them, so that a forest of still branches costs nothing.
class TreeNode : public osg::PositionAttitudeTransform {
public:
    /// Draws nothing.
    TreeNode();
    /// A tree at rest.
    TreeNode(TreeShape* shape, const TreeStyle& style, const TreeScale& scale);
    /// A tree of the same shape, size and place, at rest; nodes hung on branches are not copied.
    TreeNode(const TreeNode& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, TreeNode)

        /// Units of this tree; 0 for an empty one.
        unsigned getNumBranches() const;
    /// The transform of a unit (access order), in the current pose; null beyond getNumBranches(). It follows
    /// the tree from then on. Call it where the scene may be changed (update or event traversal, between
    /// frames).
    BranchTransform* getBranch(unsigned unit);

    /// Draws the bark branch by branch below BranchTransforms (the thesis' way) instead of in one draw.
    void setBranchwise(bool branchwise);
    bool getBranchwise() const { return _branchwise; }

    /// Gives every leaf cluster a MatrixTransform below its branch, over one shared drawable (§2.4.1, as
    /// published), instead of all of them in one draw.
    void setLeafwise(bool leafwise);
    bool getLeafwise() const { return _leafwise; }

    /// The tree as it stands; null for an empty one.
    PosedTree* getPosedTree() const { return _tree.get(); }

    /// Where the shaders find this tree: first texels of its units and leaves. Negative: at rest.
    void setTexels(int firstUnit, int firstLeaf);

    /// A number in [0, 1) that is this tree's own: leaves have a shade after it.
    void setOwnNumber(float number);

    /// Takes over the pose of getPosedTree() after it changed: bounds and branch transforms.
    void updatePose();

protected:
    ~TreeNode() override = default;

private:
    void turnLeaves();
    void build(TreeShape* shape, const TreeStyle& style, const TreeScale& scale);

    osg::ref_ptr<TreeShape> _shape;
    TreeStyle _style;
    osg::ref_ptr<PosedTree> _tree;
    osg::ref_ptr<osg::Drawable> _skin, _leaves;
    std::vector<osg::ref_ptr<BranchTransform>> _branches; // those asked for, by unit
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _leafTransforms;
    bool _branchwise = false, _leafwise = false;
};

} // namespace osgTreeWind
