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
    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return _className; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    /// Hands over the posed triangles, in the tree's frame.
    void accept(osg::PrimitiveFunctor& functor) const override;

    const osg::Geometry* geometry() const { return _geometry.get(); }
    osg::Geometry* geometry() { return _geometry.get(); }

    osg::BoundingBox computeBoundingBox() const override {
        return _tree ? _tree->bounds() : osg::BoundingBox();
    }
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void compileGLObjects(osg::RenderInfo& renderInfo) const override;

protected:
    /// @param geometry shared by trees; @param tree the one drawn here; null for what is the same in all.
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

/// The bark of a tree: all of it, posed, or that of one branch unit at rest to stand below a BranchTransform.
class SkinDrawable : public TreeDrawable {
public:
    static constexpr int wholeTree = -1;

    /// @param geometry the model's skin, or its unitSkin(unit).
    explicit SkinDrawable(osg::Geometry* geometry = nullptr, PosedTree* tree = nullptr, int unit = wholeTree)
        : TreeDrawable("SkinDrawable", geometry, tree), _unit(unit) {}
    osg::BoundingBox computeBoundingBox() const override;

protected:
    Triangles posedTriangles() const override;

private:
    int _unit;
};

/// All leaf clusters of a tree in one draw; the vertex shader fetches the angles of each.
class LeafDrawable : public TreeDrawable {
public:
    explicit LeafDrawable(osg::Geometry* geometry = nullptr, PosedTree* tree = nullptr)
        : TreeDrawable("LeafDrawable", geometry, tree) {}

protected:
    Triangles posedTriangles() const override;
};

} // namespace osgTreeWind
