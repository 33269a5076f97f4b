// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osg/MatrixTransform>

namespace osgTreeWind {

class FollowedBranches;

/// A transform that moves with one branch unit: it rotates about the base of the unit and carries its
/// children (the glPushMatrix and glPopMatrix of thesis §3.1.3). Children use the coordinates of the tree at
/// rest, so a node placed at a rest position of the branch stays attached to it. Changed in the update
/// traversal or between frames.
///
///     if (const auto unit = nearestUnit(forest->getUnits(tree), osg::Vec3(1.0f, 0.0f, 8.0f)))
///         if (const auto branch = forest->branch(tree, *unit))
///             branch.value()->addChild(nest);
class OSGTREEWIND_EXPORT BranchTransform : public osg::MatrixTransform {
public:
    BranchTransform();
    /// @param unit index in access order.
    /// @param base attach point in the tree's frame at rest, metres; the origin if a coordinate is beyond
    /// 1e8.
    BranchTransform(unsigned unit, const osg::Vec3& base);
    /// A copy for osg::clone.
    BranchTransform(const BranchTransform& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, BranchTransform)

    /// Index in access order.
    unsigned getUnit() const { return _unit; }
    const osg::Vec3& getBase() const { return _base; } ///< Attach point in the tree's frame at rest, metres.

    /// Sets the rotation of the branch about its base, in the tree's rest axes, without the rotation of its
    /// parents; sets the matrix to T(base) R T(-base). Ignores values that are not finite.
    void setRotation(const osg::Quat& rotation);
    /// The rotation of the last setRotation(); at first none.
    const osg::Quat& getRotation() const { return _rotation; }

protected:
    ~BranchTransform() override = default;

private:
    friend class FollowedBranches;
    /// Sets base, rotation and the complete matrix, for a branch whose parents are not nodes of the scene.
    void setPose(const osg::Vec3& base, const osg::Matrix& matrix, const osg::Quat& rotation);

    unsigned _unit = 0;
    osg::Vec3 _base;
    osg::Quat _rotation;
};

} // namespace osgTreeWind
