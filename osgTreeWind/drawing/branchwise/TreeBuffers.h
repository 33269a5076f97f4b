// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/species/Appearance.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// Vertex buffers of a model, shared by all its trees, with the arrays of shaders/branchwise/bark.vert and
/// shaders/branchwise/leaf.vert.
class TreeBuffers : public osg::Referenced {
public:
    explicit TreeBuffers(std::shared_ptr<const TreeModel> model, LeafForm leafForm = LeafForm::Blade);

    const std::shared_ptr<const TreeModel>& model() const { return _model; }
    osg::Geometry* skin() const { return _meshes->skin.get(); }
    osg::Geometry* leaves() const { return _meshes->leaves.get(); }
    /// The bark of the units without leaves, in the same vertex buffer.
    osg::Geometry* bareSkin() const { return _meshes->bareSkin.get(); }
    /// A leaf cluster of size 1 in the leaf frame.
    TreeDrawable* leafCluster() const { return _leafCluster.get(); }
    /// The bark of one branch unit, in the same vertex buffer. Created on first use, by one thread.
    osg::Geometry* unitSkin(unsigned unit);

    void resizeGLObjectBuffers(unsigned maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    std::vector<osg::Geometry*> geometries() const;

    /// Shared by all forests of the process with a shared model (TreeModel::identity).
    struct Meshes : osg::Referenced {
        Meshes(const TreeModel& model, LeafForm leafForm);
        osg::ref_ptr<osg::Geometry> skin, bareSkin, leaves;
    };
    static osg::ref_ptr<Meshes> sharedMeshes(const TreeModel& model, LeafForm leafForm);

    std::shared_ptr<const TreeModel> _model;
    osg::ref_ptr<Meshes> _meshes;
    osg::ref_ptr<TreeDrawable> _leafCluster;
    std::vector<osg::ref_ptr<osg::Geometry>> _unitSkins;
};

} // namespace osgTreeWind
