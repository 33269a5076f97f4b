// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/branchwise/TreeNode.h>

#include <osgTreeWind/nodes/branchwise/LeafDrawable.h>
#include <osgTreeWind/nodes/branchwise/SkinDrawable.h>

namespace osgTreeWind {
namespace {

constexpr int atRest = -1;

osg::ref_ptr<osg::Drawable> styled(osg::Drawable* drawable, osg::StateSet* state) {
    drawable->setStateSet(state);
    return drawable;
}

} // namespace

TreeNode::TreeNode() {
    setDataVariance(osg::Object::DYNAMIC);
}

TreeNode::TreeNode(TreeShape* shape, const TreeStyle& style, const TreeScale& scale) : TreeNode() {
    build(shape, style, scale);
}

TreeNode::TreeNode(const TreeNode& other, const osg::CopyOp& copyop)
    : osg::PositionAttitudeTransform(other, copyop) {
    setDataVariance(osg::Object::DYNAMIC);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (dynamic_cast<TreeDrawable*>(getChild(i)) || dynamic_cast<BranchTransform*>(getChild(i)))
            removeChild(i);
    if (getStateSet()) // texels and sizes are the copy's own
        setStateSet(new osg::StateSet(*getStateSet(), osg::CopyOp::DEEP_COPY_UNIFORMS));
    if (other._tree) {
        build(other._shape, other._style, other._tree->scale());
        setBranchwise(other._branchwise);
        setLeafwise(other._leafwise);
    }
}

void TreeNode::build(TreeShape* shape, const TreeStyle& style, const TreeScale& scale) {
    _shape = shape;
    _style = style;
    _tree = new PosedTree(shape->model(), scale);
    _branches.resize(getNumBranches());
    _skin = styled(new SkinDrawable(shape->skin(), _tree), style.bark);
    _leaves = styled(new LeafDrawable(shape->leaves(), _tree), style.leaves);
    addChild(_skin);
    addChild(_leaves);

    osg::StateSet* state = getOrCreateStateSet();
    state->addUniform(new osg::Uniform("treeAxes", toOsg(scale.axes)));
    state->addUniform(new osg::Uniform("treeSizes", osg::Vec2(scale.radius, scale.leaf)));
    setTexels(atRest, atRest);
}

unsigned TreeNode::getNumBranches() const {
    return _tree ? static_cast<unsigned>(_tree->model().skeleton.units.size()) : 0;
}

BranchTransform* TreeNode::getBranch(unsigned unit) {
    if (unit >= getNumBranches())
        return nullptr;
    if (!_branches[unit]) {
        const BranchUnit& rest = _tree->model().skeleton.units[unit];
        _branches[unit] = new BranchTransform(unit, toOsg(_tree->scale().axes * rest.base));
        _branches[unit]->setRotation(toOsg(_tree->rotation(unit)));
        osg::Group* parent = this;
        if (rest.parent >= 0)
            parent = getBranch(static_cast<unsigned>(rest.parent));
        parent->addChild(_branches[unit]);
    }
    return _branches[unit].get();
}

void TreeNode::setBranchwise(bool branchwise) {
    if (branchwise == _branchwise || !_tree)
        return;
    _branchwise = branchwise;
    if (branchwise) {
        removeChild(_skin);
        for (unsigned unit = 0; unit < getNumBranches(); ++unit)
            getBranch(unit)->addChild(styled(
                new SkinDrawable(_shape->unitSkin(unit), _tree, static_cast<int>(unit)), _style.branchBark));
    } else {
        addChild(_skin);
        for (const osg::ref_ptr<BranchTransform>& branch : _branches)
            for (unsigned i = branch->getNumChildren(); i-- > 0;)
                if (dynamic_cast<SkinDrawable*>(branch->getChild(i)))
                    branch->removeChild(i);
    }
}

void TreeNode::setLeafwise(bool leafwise) {
    if (leafwise == _leafwise || !_tree)
        return;
    _leafwise = leafwise;
    if (!leafwise) {
        addChild(_leaves);
        for (const osg::ref_ptr<osg::MatrixTransform>& leaf : _leafTransforms)
            leaf->getParent(0)->removeChild(leaf);
        _leafTransforms.clear();
        return;
    }
    removeChild(_leaves);
    for (const LeafCluster& cluster : _tree->model().leaves) {
        osg::ref_ptr<osg::MatrixTransform> leaf = new osg::MatrixTransform;
        leaf->setDataVariance(osg::Object::DYNAMIC);
        leaf->setStateSet(_style.leafCluster);
        leaf->addChild(_shape->leafCluster());
        getBranch(static_cast<unsigned>(cluster.unit))->addChild(leaf);
        _leafTransforms.push_back(leaf);
    }
    turnLeaves();
}

void TreeNode::turnLeaves() {
    for (std::size_t i = 0; i < _leafTransforms.size(); ++i) {
        const LeafCluster& cluster = _tree->model().leaves[i];
        osg::Matrix matrix = osg::Matrix::scale(osg::Vec3(1, 1, 1) * (_tree->scale().leaf * cluster.size));
        matrix.postMultRotate(toOsg(_tree->leafTurn(i)));
        matrix.postMultTranslate(toOsg(_tree->scale().axes * cluster.anchor));
        _leafTransforms[i]->setMatrix(matrix);
    }
}

void TreeNode::setTexels(int firstUnit, int firstLeaf) {
    osg::StateSet* state = getOrCreateStateSet();
    state->getOrCreateUniform("treeFirstUnit", osg::Uniform::INT)->set(firstUnit);
    state->getOrCreateUniform("treeFirstLeaf", osg::Uniform::INT)->set(firstLeaf);
}

void TreeNode::setOwnNumber(float number) {
    getOrCreateStateSet()->getOrCreateUniform("treeOwn", osg::Uniform::FLOAT)->set(number);
}

void TreeNode::updatePose() {
    if (!_tree)
        return;
    if (_tree->growBounds()) {
        _skin->dirtyBound();
        _leaves->dirtyBound();
    }
    for (const osg::ref_ptr<BranchTransform>& branch : _branches)
        if (branch)
            branch->setRotation(toOsg(_tree->rotation(branch->getUnit())));
    turnLeaves();
}

} // namespace osgTreeWind
