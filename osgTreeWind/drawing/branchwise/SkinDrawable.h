// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

namespace osgTreeWind {

/// The bark of a tree: all of it, posed, or that of one branch unit at rest to stand below a BranchTransform.
class SkinDrawable : public TreeDrawable {
public:
    static constexpr int wholeTree = -1;

    SkinDrawable() = default;
    /// @param geometry the model's skin, or its unitSkin(unit).
    SkinDrawable(osg::Geometry* geometry, PosedTree* tree, int unit = wholeTree);
    SkinDrawable(const SkinDrawable& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    using TreeDrawable::accept;
    META_Node(osgTreeWind, SkinDrawable)

        osg::BoundingBox computeBoundingBox() const override;

protected:
    ~SkinDrawable() override = default;
    Triangles posedTriangles() const override;

private:
    int _unit = wholeTree;
};

} // namespace osgTreeWind
