// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osg/MatrixTransform>

namespace osgTreeWind {

class FollowedBranches;

/// One branch unit as a transform: it turns about its base, and everything below it goes along (the
/// glPushMatrix and glPopMatrix of thesis §3.1.3). Coordinates below it are those of the tree at rest, so a
/// node placed at a rest position of the branch stays attached to it. Changed in update, or between frames.
///
///     if (const auto unit = nearestUnit(forest->getUnits(tree), osg::Vec3(1.0f, 0.0f, 8.0f)))
///         if (const auto branch = forest->branch(tree, *unit))
///             branch.value()->addChild(nest);
class OSGTREEWIND_EXPORT BranchTransform : public osg::MatrixTransform {
public:
    BranchTransform();
    /// @param unit index in access order; @param base attach point in the tree's frame at rest, metres, each
    /// within 1e8; else it counts as 0.
    BranchTransform(unsigned unit, const osg::Vec3& base);
    /// A copy for osg::clone.
    BranchTransform(const BranchTransform& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, BranchTransform)

        /// Index in access order.
        unsigned getUnit() const {
        return _unit;
    }
    const osg::Vec3& getBase() const { return _base; } ///< Attach point, tree's frame, at rest, metres.

    /// The branch's own turn about its base, in the tree's rest axes, under any law. Setting it sets the
    /// matrix T(base) R T(-base). What is not finite is ignored.
    void setRotation(const osg::Quat& rotation);
    const osg::Quat& getRotation() const { return _rotation; } ///< As set last.

protected:
    ~BranchTransform() override = default;

private:
    friend class FollowedBranches;
    /// Another base, and a turn about it where what carries the branch stands above no node: the matrix is
    /// given whole.
    void setPose(const osg::Vec3& base, const osg::Matrix& matrix, const osg::Quat& rotation);

    unsigned _unit = 0;
    osg::Vec3 _base;
    osg::Quat _rotation;
};

} // namespace osgTreeWind
