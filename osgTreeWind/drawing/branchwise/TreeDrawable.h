// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/PosedTree.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// A part of one tree, drawn from geometry that all trees of its model share, and that is released by its
/// TreeBuffers only. Vertices are posed by shaders;
/// for bounds, picking and statistics they are posed on the CPU.
class TreeDrawable : public osg::Drawable {
public:
    /// @param geometry shared by trees; @param tree the one drawn here; null for what is the same in all.
    TreeDrawable(osg::Geometry* geometry, PosedTree* tree);
    TreeDrawable(const TreeDrawable& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    /// Hands over the posed triangles, in the tree's frame.
    void accept(osg::PrimitiveFunctor& functor) const override;

    const osg::Geometry* geometry() const { return _geometry.get(); }
    osg::Geometry* geometry() { return _geometry.get(); }

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;

protected:
    TreeDrawable() = default;
    ~TreeDrawable() override = default;

    struct Triangles {
        std::vector<osg::Vec3> vertices;
        std::vector<unsigned> indices;
    };
    virtual Triangles posedTriangles() const = 0;

    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<PosedTree> _tree;
};

} // namespace osgTreeWind
