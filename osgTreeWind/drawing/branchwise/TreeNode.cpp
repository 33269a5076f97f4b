// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeNode.h>

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/model/MeasureTree.h>

#include <osgUtil/IntersectionVisitor>

#include <algorithm>
#include <utility>

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

TreeNode::TreeNode(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale) : TreeNode() {
    build(buffers, style, scale);
}

TreeNode::TreeNode(const TreeNode& other, const osg::CopyOp& copyop)
    : osg::PositionAttitudeTransform(other, copyop) {
    setDataVariance(osg::Object::DYNAMIC);
    for (unsigned i = getNumChildren(); i-- > 0;)
        if (dynamic_cast<TreeLod*>(getChild(i)))
            removeChild(i);
    if (getStateSet()) // the copy has its own texels and sizes
        setStateSet(new osg::StateSet(*getStateSet(), osg::CopyOp::DEEP_COPY_UNIFORMS));
    if (other._tree) {
        _leafShare = other._leafShare;
        build(other._buffers, other._style, other._tree->scale());
        _lod->setRanges(other._lod->getRanges());
    }
}

void TreeNode::build(TreeBuffers* buffers, const TreeStyle& style, const TreeScale& scale) {
    _buffers = buffers;
    _style = style;
    _tree = new PosedTree(buffers->model(), scale);
    _branches.resize(getNumBranches());
    _skin = styled(new SkinDrawable(buffers->skin(), _tree), style.bark);
    _leaves = styled(new LeafDrawable(buffers->leaves(), _tree), style.leaves);
    _bareSkin = styled(new SkinDrawable(buffers->bareSkin(), _tree), style.bark);
    _lod = new TreeLod(measureTree(buffers->model()->extents, scale).height);
    for (osg::Drawable* drawable : {_skin.get(), _leaves.get()})
        _lod->level(TreeLod::STAND_IN)->addChild(drawable);
    for (osg::Drawable* drawable : {_bareSkin.get(), _leaves.get()})
        _lod->level(TreeLod::LEAVES)->addChild(drawable);
    _lod->setFullReady(false);
    addChild(_lod);

    osg::StateSet* state = getOrCreateStateSet();
    state->addUniform(new osg::Uniform("treeAxes", toOsg(scale.axes)));
    state->addUniform(new osg::Uniform("treeSizes", osg::Vec2(scale.radius, scale.leaf)));
    setTexels(atRest, atRest);
    setLeafShare(_leafShare);
}

unsigned TreeNode::getNumBranches() const {
    return _tree ? static_cast<unsigned>(_tree->model().skeleton.units.size()) : 0;
}

BranchTransform* TreeNode::getBranch(unsigned unit) {
    if (unit >= getNumBranches())
        return nullptr;
    BranchTransform* const transform = branch(unit);
    if (std::exchange(_branches[unit].isRequested, true))
        return transform;
    for (int at = static_cast<int>(unit); at >= 0; at = parentOf(at))
        if (Branch& carrier = _branches[static_cast<std::size_t>(at)]; carrier.requests++ == 0)
            carrier.transform->setRotation(toOsg(_tree->rotation(static_cast<std::size_t>(at))));
    return transform;
}

bool TreeNode::releaseBranch(unsigned unit) {
    if (unit >= getNumBranches() || !std::exchange(_branches[unit].isRequested, false))
        return false;
    for (int at = static_cast<int>(unit); at >= 0; at = parentOf(at))
        --_branches[static_cast<std::size_t>(at)].requests;
    BranchTransform& transform = *_branches[unit].transform;
    for (unsigned i = transform.getNumChildren(); i-- > 0;)
        if (!isTreePart(transform.getChild(i)))
            transform.removeChild(i);
    return true;
}

int TreeNode::parentOf(int unit) const {
    return _tree->model().skeleton.units[static_cast<std::size_t>(unit)].parent;
}

/// Whether a child of a branch belongs to the tree and not to the host.
bool TreeNode::isTreePart(const osg::Node* child) const {
    return dynamic_cast<const BranchTransform*>(child) || dynamic_cast<const SkinDrawable*>(child) ||
           std::find(_leafTransforms.begin(), _leafTransforms.end(), child) != _leafTransforms.end();
}

BranchTransform* TreeNode::branch(unsigned unit) {
    osg::ref_ptr<BranchTransform>& transform = _branches[unit].transform;
    if (!transform) {
        const BranchUnit& rest = _tree->model().skeleton.units[unit];
        transform = new BranchTransform(unit, toOsg(_tree->scale().axes * rest.base));
        osg::Group* const parent =
            rest.parent >= 0 ? branch(static_cast<unsigned>(rest.parent)) : _lod->level(TreeLod::FULL);
        parent->addChild(transform);
    }
    return transform.get();
}

void TreeNode::makeTransforms() {
    if (_hasTransforms)
        return;
    _hasTransforms = true;
    for (unsigned unit = 0; unit < getNumBranches(); ++unit)
        branch(unit)->addChild(styled(
            new SkinDrawable(_buffers->unitSkin(unit), _tree, static_cast<int>(unit)), _style.branchBark));
    for (const LeafCluster& cluster : _tree->model().leaves) {
        osg::ref_ptr<osg::MatrixTransform> leaf = new osg::MatrixTransform;
        leaf->setDataVariance(osg::Object::DYNAMIC);
        leaf->addChild(_buffers->leafCluster());
        branch(static_cast<unsigned>(cluster.unit))->addChild(leaf);
        _leafTransforms.push_back(leaf);
    }
    updateLeafStates();
}

void TreeNode::updateLeafStates() {
    for (std::size_t i = 0; i < _leafTransforms.size(); ++i)
        _leafTransforms[i]->setStateSet(isClusterBorne(i, _leafShare) ? _style.leafCluster
                                                                      : _style.bareCluster);
}

void TreeNode::turnBranches(bool all) {
    for (const Branch& branch : _branches)
        if (branch.transform && (all || branch.requests > 0))
            branch.transform->setRotation(toOsg(_tree->rotation(branch.transform->getUnit())));
}

void TreeNode::turnLeaves() {
    for (std::size_t i = 0; i < _leafTransforms.size(); ++i) {
        const LeafCluster& cluster = _tree->model().leaves[i];
        osg::Matrix matrix = osg::Matrix::scale(osg::Vec3(1, 1, 1) * (_tree->scale().leaf * cluster.size));
        matrix.postMultRotate(toOsg(_tree->leafOrientation(i)));
        matrix.postMultTranslate(toOsg(_tree->scale().axes * cluster.anchor));
        _leafTransforms[i]->setMatrix(matrix);
    }
}

/// Sets the level FULL to the current pose.
void TreeNode::updateFullLevel() {
    makeTransforms();
    turnBranches(true);
    turnLeaves();
    _lod->setFullReady(true);
}

void TreeNode::setTexels(int firstUnit, int firstLeaf) {
    osg::StateSet* state = getOrCreateStateSet();
    state->getOrCreateUniform("treeFirstUnit", osg::Uniform::INT)->set(firstUnit);
    state->getOrCreateUniform("treeFirstLeaf", osg::Uniform::INT)->set(firstLeaf);
}

void TreeNode::setTreeRandom(float number) {
    getOrCreateStateSet()->getOrCreateUniform("treeOwn", osg::Uniform::FLOAT)->set(number);
}

void TreeNode::setLeafShare(float share) {
    _leafShare = share;
    getOrCreateStateSet()->getOrCreateUniform("treeLeaves", osg::Uniform::FLOAT)->set(share);
    updateLeafStates();
}

void TreeNode::setBillboard(osg::Drawable* picture) {
    osg::Group& level = *_lod->level(TreeLod::BILLBOARD);
    level.removeChildren(0, level.getNumChildren());
    level.addChild(picture);
    _lod->setRanges(_lod->getRanges());
}

void TreeNode::updatePose(bool moved) {
    if (!_tree)
        return;
    if (moved && _tree->growBounds())
        for (const osg::ref_ptr<osg::Drawable>& drawable : {_skin, _leaves, _bareSkin})
            drawable->dirtyBound();
    const bool wanted = _lod->takeFullRequest();
    if (wanted && (moved || !_lod->isFullReady())) {
        updateFullLevel();
    } else if (moved) {
        turnBranches(false);
        _lod->setFullReady(false);
    }
}

void TreeNode::traverse(osg::NodeVisitor& visitor) {
    if (_tree && !_lod->isFullReady() && dynamic_cast<osgUtil::IntersectionVisitor*>(&visitor))
        ExceptionGuard().run("a tree may not be picked", [this] { updateFullLevel(); });
    osg::PositionAttitudeTransform::traverse(visitor);
}

} // namespace osgTreeWind
