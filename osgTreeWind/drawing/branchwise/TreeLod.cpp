// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeLod.h>

#include <algorithm>
#include <limits>

namespace osgTreeWind {

TreeLod::TreeLod() : TreeLod(1.0f) {}

TreeLod::TreeLod(float height) : _height(height) {
    setDataVariance(osg::Object::DYNAMIC);
    setCenterMode(UNION_OF_BOUNDING_SPHERE_AND_USER_DEFINED);
    setCenter(osg::Vec3(0.0f, 0.0f, 0.5f * height));
    setRadius(0.0f);
    for (const char* name : {"full", "leaves", "billboard", "stand-in"}) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->setDataVariance(osg::Object::DYNAMIC);
        group->addDescription(name); // keeps osgUtil::Optimizer from removing it while empty
        addChild(group);
    }
    setRanges(TreeLodRanges());
}

TreeLod::TreeLod(const TreeLod& other, const osg::CopyOp& copyop)
    : osg::LOD(other, copyop), _ranges(other._ranges), _height(other._height), _fullReady(other._fullReady) {
    setDataVariance(osg::Object::DYNAMIC);
    for (unsigned i = 0; i < getNumChildren(); ++i)
        if (getChild(i) == other.getChild(i))
            setChild(i, osg::clone(getChild(i)));
}

void TreeLod::setRanges(const TreeLodRanges& ranges) {
    _ranges = ranges;
    const float largest = std::numeric_limits<float>::max();
    const bool pictured = level(BILLBOARD)->getNumChildren() > 0;
    const float full = std::min(ranges.full * _height, largest);
    const float leaves = pictured ? std::max(full, std::min(ranges.leaves * _height, largest)) : largest;
    setRange(FULL, 0.0f, full);
    setRange(LEAVES, full, leaves);
    setRange(BILLBOARD, leaves, largest);
    setRange(STAND_IN, largest, largest);
}

void TreeLod::traverse(osg::NodeVisitor& visitor) {
    if (visitor.getTraversalMode() != osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN ||
        visitor.getDistanceToViewPoint(getCenter(), true) >= getMaxRange(FULL)) {
        osg::LOD::traverse(visitor);
        return;
    }
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR)
        _fullRequested = true;
    getChild(_fullReady ? FULL : STAND_IN)->accept(visitor);
}

} // namespace osgTreeWind
