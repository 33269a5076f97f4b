// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/instanced/LeafOrders.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Appearance.h>

#include <osg/Geometry>
#include <osg/StateSet>

#include <vector>

namespace osgTreeWind {

/// The geometry of a model at each tier with branches. It does not change once it is made.
struct ModelMeshes : osg::Referenced {
    ModelMeshes(const TreeModel& model, const Appearance& appearance);

    osg::ref_ptr<osg::Geometry> bark[branchTiers];
    LeafOrders::Geometries leaves[branchTiers];      ///< Null in a tree without leaves.
    osg::ref_ptr<osg::StateSet> states[branchTiers]; ///< Where shaders find poses, and how bright leaves are.
    LeafStencils::Atlas stencils;                    ///< Held for the next one, and for pictures.
};

/// What the trees of one model are drawn from in a forest, at each tier; forests share its parts.
class ModelResources : public osg::Referenced {
public:
    /// @param species that it is a model of.
    ModelResources(const TreeModel& model, std::size_t species, const Appearance& appearance);
    /// As another one, but drawn from these of a host at every tier; null for none.
    ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves);
    /// Its pictures need not show what they look like then.
    bool isOfHost() const { return _isOfHost; }

    /// Null where there is none, as the next one.
    osg::Geometry* bark(Tier tier) const {
        return _isOfHost ? _hostBark.get() : _meshes->bark[static_cast<int>(tier)].get();
    }
    /// @param order LeafOrders::nearest()
    osg::Geometry* leaves(Tier tier, std::size_t order) const {
        return _isOfHost ? _hostLeaves.get() : _meshes->leaves[static_cast<int>(tier)][order].get();
    }
    /// Null before it was painted.
    const ImpostorStrip* impostor(Tier tier) const {
        return _impostors[static_cast<int>(tier) - branchTiers].get();
    }
    /// Takes the impostor of that tier (sharedImpostor()). In update; different threads may take different
    /// ones.
    void paint(Tier tier, const TreeModel& model, const Appearance& appearance);

    std::size_t species() const { return _species; }
    /// Where shaders find its poses at that tier.
    osg::StateSet* state(Tier tier) const { return _meshes->states[static_cast<int>(tier)].get(); }

    /// Adds geometries and state sets: all that OpenGL keeps something of.
    void addGLObjects(std::vector<osg::Object*>& objects) const;

private:
    std::size_t _species;
    bool _isOfHost = false;
    osg::ref_ptr<ModelMeshes> _meshes;
    osg::ref_ptr<osg::Geometry> _hostBark, _hostLeaves;
    osg::ref_ptr<ImpostorStrip> _impostors[impostorTiers];
};

/// The pictures of a model at an impostor tier, painted in tens of milliseconds: the same ones for all in the
/// process who hold them, where the model is shared (TreeModel::identity). Any thread.
osg::ref_ptr<ImpostorStrip> sharedImpostor(const TreeModel& model, const Appearance& appearance, Tier tier);

} // namespace osgTreeWind
