// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/instanced/MeshParts.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Appearance.h>

#include <osg/Geometry>
#include <osg/StateSet>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// The bark or the leaves of a model: vertices and triangle indices of all tiers with branches, and the parts
/// of each tier. Tiers may share parts. Leaves have no vertices, but records in a texture of their state. The
/// geometry is null without triangles; that of bark is a RefilledGeometry.
struct TierMeshes {
    osg::ref_ptr<osg::Geometry> geometry;
    std::vector<MeshPart> parts[branchTiers];
};

/// The meshes of a model. Immutable.
struct ModelMeshes : osg::Referenced {
    ModelMeshes(const std::shared_ptr<const TreeModel>& model, const Appearance& appearance);

    TierMeshes bark, leaves;
    osg::ref_ptr<osg::StateSet> state; ///< Of all tiers (shaders/instance.glsl, leaf_corner.glsl).
    float leafBrightness[branchTiers]; ///< Factors that give each tier the brightness of the full one.
    LeafStencils::Atlas stencils;      ///< Kept alive for further models and for impostors.
};

/// Geometry and state of one model in a forest, at each tier. Forests share meshes and impostors.
class ModelResources : public osg::Referenced {
public:
    /// @param species index of the species of the model.
    ModelResources(const std::shared_ptr<const TreeModel>& model, std::size_t species,
                   const Appearance& appearance);
    /// A copy with the geometry of a host at every tier with branches; null draws nothing.
    ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves);
    /// If true, the impostors may look different from the geometry.
    bool usesHostGeometry() const { return _usesHostGeometry; }

    const ModelMeshes& meshes() const { return *_meshes; }
    osg::Geometry* hostBark() const { return _hostBark.get(); }     ///< May be null.
    osg::Geometry* hostLeaves() const { return _hostLeaves.get(); } ///< May be null.
    /// Null before loadImpostor().
    const ImpostorStrip* impostor(Tier tier) const {
        return _impostors[static_cast<int>(tier) - branchTiers].get();
    }
    /// Sets the impostor of a tier to sharedImpostor(). In update; threads may load different tiers at once.
    void loadImpostor(Tier tier, const TreeModel& model, const Appearance& appearance);

    std::size_t species() const { return _species; }
    /// State of all tiers with branches.
    osg::StateSet* state() const { return _meshes->state.get(); }

    /// Appends all geometries and state sets that have OpenGL objects.
    void addGLObjects(std::vector<osg::Object*>& objects) const;

private:
    std::size_t _species;
    bool _usesHostGeometry = false;
    osg::ref_ptr<ModelMeshes> _meshes;
    osg::ref_ptr<osg::Geometry> _hostBark, _hostLeaves;
    osg::ref_ptr<ImpostorStrip> _impostors[impostorTiers];
};

/// The impostor of a model at an impostor tier. Painting takes tens of milliseconds; forests of the process
/// share the impostor of a shared model (TreeModel::identity) while one of them holds it. Any thread.
osg::ref_ptr<ImpostorStrip> sharedImpostor(const TreeModel& model, const Appearance& appearance, Tier tier);

} // namespace osgTreeWind
