// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/species/Appearance.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// The drawn form of a model, shared by all its trees: vertex buffers for bark and leaves as
/// shaders/branchwise/bark.vert and shaders/branchwise/leaf.vert describe them.
class TreeBuffers : public osg::Referenced {
public:
    explicit TreeBuffers(std::shared_ptr<const TreeModel> model, LeafForm leafForm = LeafForm::Blade);

    const std::shared_ptr<const TreeModel>& model() const { return _model; }
    osg::Geometry* skin() const { return _meshes->skin.get(); }
    osg::Geometry* leaves() const { return _meshes->leaves.get(); }
    /// The bark of the units that bear no leaves, over the same vertex buffer.
    osg::Geometry* bareSkin() const { return _meshes->bareSkin.get(); }
    /// One in the leaf frame, size 1.
    TreeDrawable* leafCluster() const { return _leafCluster.get(); }
    /// The bark of one branch unit, over the same vertex buffer. Made on the first call; call it from one
    /// thread.
    osg::Geometry* unitSkin(unsigned unit);

    void resizeGLObjectBuffers(unsigned maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    std::vector<osg::Geometry*> geometries() const;

    /// The same ones for all forests that hold them.
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
