// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

namespace osgTreeWind {

/// A tree as a picture that faces the eye and stands still (thesis §7): the strip of an ImpostorStrip.
class BillboardDrawable : public TreeDrawable {
public:
    BillboardDrawable() = default;
    /// @param ownNumber of the tree, [0, 1).
    BillboardDrawable(osg::Geometry* geometry, PosedTree* tree, float ownNumber)
        : TreeDrawable(geometry, tree), _ownNumber(ownNumber) {}
    BillboardDrawable(const BillboardDrawable& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY)
        : TreeDrawable(other, copyop), _ownNumber(other._ownNumber) {}
    using TreeDrawable::accept;
    META_Node(osgTreeWind, BillboardDrawable)

        osg::BoundingBox computeBoundingBox() const override;
    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~BillboardDrawable() override = default;
    Triangles posedTriangles() const override { return {}; } // nothing to pick on a picture

private:
    float _ownNumber = 0.0f;
};

} // namespace osgTreeWind
