// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelResources.h>

#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/SharedObjects.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/LeafCoverage.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

namespace osgTreeWind {

namespace {

/// Adds the vertices of a tier, and its parts, whose indices follow those of the tiers before.
void addTier(TierMeshes& meshes, int tier, const osg::ref_ptr<osg::Geometry>& added,
             std::vector<MeshPart> parts, std::vector<std::uint32_t>& indices) {
    const int firstVertex = meshes.geometry ? appendVertices(*meshes.geometry, *added) : 0;
    const auto firstIndex = static_cast<std::uint32_t>(indices.size());
    for (MeshPart& part : parts) {
        part.firstIndex += firstIndex;
        part.firstVertex = firstVertex;
    }
    osg::DrawElements& triangles = *added->getPrimitiveSet(0)->getDrawElements();
    for (unsigned i = 0; i < triangles.getNumIndices(); ++i)
        indices.push_back(triangles.getElement(i));
    meshes.parts[tier] = std::move(parts);
    if (!meshes.geometry)
        meshes.geometry = added;
}

void setTriangles(TierMeshes& meshes, const std::vector<std::uint32_t>& indices) {
    if (!meshes.geometry)
        return;
    const bool isShort = *std::max_element(indices.begin(), indices.end()) < 65536;
    osg::ref_ptr<osg::PrimitiveSet> triangles;
    if (isShort)
        triangles = new osg::DrawElementsUShort(GL_TRIANGLES, indices.begin(), indices.end());
    else
        triangles = new osg::DrawElementsUInt(GL_TRIANGLES, indices.begin(), indices.end());
    meshes.geometry->setPrimitiveSet(0, triangles);
    makeArraysDistinct(*meshes.geometry);
}

} // namespace

ModelMeshes::ModelMeshes(const TreeModel& model, const Appearance& appearance) {
    const float coverage = leafCoverage(appearance.leafForm), height = model.skeleton.height();
    const CrownShade crown(model.leaves, model.leafMesh, coverage);
    stencils = LeafStencils::ofAtlas(leafImage(appearance));
    std::vector<std::uint32_t> barkIndices, leafIndices;
    float fullTierLight = 0.0f; // on the leaves
    for (int tier = 0; tier < branchTiers; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        const TreeDetail detail = TreeDetail::reduced(tier);
        BranchSkin skin = whole ? model.skin : thinnedSkin(model.skeleton, detail);
        std::vector<MeshPart> parts = sortIntoParts(skin, height);
        addTier(bark, tier, makeSkinGeometry(skin, model.skeleton, crown), std::move(parts), barkIndices);
        leafBrightness[tier] = 1.0f;
        if (tier == static_cast<int>(Tier::Sprays)) {
            leaves.parts[tier] = leaves.parts[static_cast<int>(Tier::Full)];
        } else if (!model.leaves.empty()) {
            ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, detail);
            const float seen = visibleLeafLight(leafPieces(thinned, model.leafMesh, crown, appearance, 1.0f),
                                                *stencils, appearance, height);
            parts = sortIntoParts(thinned, model.leafMesh, coverage, height);
            addTier(leaves, tier, makeLeafGeometry(thinned, model.skeleton, model.leafMesh, crown),
                    std::move(parts), leafIndices);
            fullTierLight = whole ? seen : fullTierLight;
            leafBrightness[tier] = seen > 0.0f ? fullTierLight / seen : 1.0f;
        }
    }
    setTriangles(bark, barkIndices);
    setTriangles(leaves, leafIndices);
}

namespace {

/// The meshes of a model; forests of the process share those of a shared model (TreeModel::identity) while
/// one of them holds them. Any thread.
osg::ref_ptr<ModelMeshes> sharedMeshes(const TreeModel& model, const Appearance& appearance) {
    using Cards = std::tuple<LeafForm, std::string, float>; // the fields that meshes depend on
    static SharedObjects<std::pair<std::uint64_t, Cards>, ModelMeshes> meshes;
    const auto make = [&] { return osg::ref_ptr<ModelMeshes>(new ModelMeshes(model, appearance)); };
    const Cards cards{appearance.leafForm, appearance.leafImage, appearance.underside};
    return model.identity == 0 ? make() : meshes.get({model.identity, cards}, make);
}

} // namespace

ModelResources::ModelResources(const TreeModel& model, std::size_t species, const Appearance& appearance)
    : _species(species), _meshes(sharedMeshes(model, appearance)), _state(new osg::StateSet) {
    _state->addUniform(new osg::Uniform("unitRows", PoseLayout(model.skeleton.units.size()).rows));
}

ModelResources::ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves)
    : _species(other._species), _usesHostGeometry(true), _meshes(other._meshes), _state(other._state),
      _hostBark(bark), _hostLeaves(leaves) {
    std::copy(std::begin(other._impostors), std::end(other._impostors), _impostors);
}

void ModelResources::loadImpostor(Tier tier, const TreeModel& model, const Appearance& appearance) {
    _impostors[static_cast<int>(tier) - branchTiers] = sharedImpostor(model, appearance, tier);
}

void ModelResources::addGLObjects(std::vector<osg::Object*>& objects) const {
    for (osg::Geometry* geometry :
         {_meshes->bark.geometry.get(), _meshes->leaves.geometry.get(), hostBark(), hostLeaves()})
        if (geometry)
            objects.push_back(geometry);
    for (const osg::ref_ptr<ImpostorStrip>& impostor : _impostors)
        if (impostor)
            objects.insert(objects.end(),
                           {impostor->geometry(), impostor->straightGeometry(), impostor->stateSet()});
}

osg::ref_ptr<ImpostorStrip> sharedImpostor(const TreeModel& model, const Appearance& appearance, Tier tier) {
    using Key = std::tuple<std::uint64_t, std::string, Tier, const osg::Program*>;
    static SharedObjects<Key, ImpostorStrip> impostors;
    const osg::ref_ptr<osg::Program> program =
        sharedProgram("impostor", "impostor"); // part of the key: a host may replace its files
    const auto make = [&] {
        ImpostorSettings settings;
        settings.leaves = shownLeafShare(tier);
        osg::ref_ptr<ImpostorStrip> impostor =
            new ImpostorStrip(paintImpostor(model, appearance, settings), program);
        impostor->stateSet()->addUniform(new osg::Uniform("tierColor", tierColor(tier)));
        return impostor;
    };
    if (model.identity == 0)
        return make();
    std::string look;
    addKeyBytes(appearance, look);
    return impostors.get({model.identity, look, tier, program.get()}, make);
}

} // namespace osgTreeWind
