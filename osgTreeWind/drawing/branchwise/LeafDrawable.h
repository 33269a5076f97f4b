// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

namespace osgTreeWind {

/// All leaf clusters of a tree in one draw; the vertex shader fetches the angles of each.
class LeafDrawable : public TreeDrawable {
public:
    LeafDrawable() = default;
    LeafDrawable(osg::Geometry* geometry, PosedTree* tree) : TreeDrawable(geometry, tree) {}
    LeafDrawable(const LeafDrawable& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY)
        : TreeDrawable(other, copyop) {}
    using TreeDrawable::accept;
    META_Node(osgTreeWind, LeafDrawable)

        osg::BoundingBox computeBoundingBox() const override {
        return _tree ? _tree->bounds() : osg::BoundingBox();
    }

protected:
    ~LeafDrawable() override = default;
    Triangles posedTriangles() const override;
};

} // namespace osgTreeWind
