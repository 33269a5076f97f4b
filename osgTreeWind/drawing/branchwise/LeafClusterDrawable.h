// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

namespace osgTreeWind {

/// One leaf cluster in the leaf frame, size 1: the thesis' display list (§2.4.1), to stand below the
/// transform of each cluster of all trees of a model.
class LeafClusterDrawable : public TreeDrawable {
public:
    LeafClusterDrawable() = default;
    explicit LeafClusterDrawable(const TreeModel& model);
    LeafClusterDrawable(const LeafClusterDrawable& other,
                        const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY)
        : TreeDrawable(other, copyop), _corners(other._corners) {}
    using TreeDrawable::accept;
    META_Node(osgTreeWind, LeafClusterDrawable)

        osg::BoundingBox computeBoundingBox() const override;

protected:
    ~LeafClusterDrawable() override = default;
    Triangles posedTriangles() const override;

private:
    std::vector<osg::Vec3> _corners;
};

} // namespace osgTreeWind
