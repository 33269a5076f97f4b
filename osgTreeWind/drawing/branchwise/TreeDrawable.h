// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/PosedTree.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// A part of one tree, drawn from geometry that all trees of its model share. Only the TreeBuffers release
/// that geometry. Shaders pose the vertices; for bounds, picking and statistics the CPU does.
class TreeDrawable : public osg::Drawable {
public:
    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return _className; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    /// Passes the posed triangles, in the tree's frame.
    void accept(osg::PrimitiveFunctor& functor) const override;

    const osg::Geometry* geometry() const { return _geometry.get(); }
    osg::Geometry* geometry() { return _geometry.get(); }

    osg::BoundingBox computeBoundingBox() const override { return _tree->bounds(); }
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;

protected:
    /// @param geometry shared by trees. @param tree to pose it for; null if it is the same for all trees.
    TreeDrawable(const char* className, osg::Geometry* geometry, PosedTree* tree);
    ~TreeDrawable() override = default;

    struct Triangles {
        std::vector<osg::Vec3> vertices;
        std::vector<unsigned> indices;
    };
    virtual Triangles posedTriangles() const = 0;

    const char* _className;
    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<PosedTree> _tree;
};

/// The bark of a whole tree, posed, or that of one branch unit at rest, for use below a BranchTransform.
class SkinDrawable : public TreeDrawable {
public:
    static constexpr int wholeTree = -1;

    /// @param geometry TreeBuffers::skin(), or unitSkin() of the unit.
    SkinDrawable(osg::Geometry* geometry, PosedTree* tree, int unit = wholeTree)
        : TreeDrawable("SkinDrawable", geometry, tree), _unit(unit) {}
    osg::BoundingBox computeBoundingBox() const override;

protected:
    Triangles posedTriangles() const override;

private:
    int _unit;
};

/// All leaf clusters of a tree in one draw. The vertex shader fetches their angles from a texture.
class LeafDrawable : public TreeDrawable {
public:
    LeafDrawable(osg::Geometry* geometry, PosedTree* tree) : TreeDrawable("LeafDrawable", geometry, tree) {}

protected:
    Triangles posedTriangles() const override;
};

} // namespace osgTreeWind
