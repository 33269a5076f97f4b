// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelResources.h>

#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
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

ModelMeshes::ModelMeshes(const TreeModel& model, const Appearance& appearance) {
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(appearance.leafForm));
    const PoseLayout layout(model.skeleton.units.size());
    stencils = LeafStencils::ofAtlas(leafImage(appearance));
    float fullTierLight = 0.0f; // on the leaves
    for (int tier = 0; tier < branchTiers; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        const TreeDetail detail = TreeDetail::reduced(tier);
        bark[tier] =
            makeSkinGeometry(whole ? model.skin : thinnedSkin(model.skeleton, detail), model.skeleton, crown);
        float brightness = 1.0f;
        if (tier == static_cast<int>(Tier::Sprays)) {
            leaves[tier] = leaves[static_cast<int>(Tier::Full)];
        } else if (!model.leaves.empty()) {
            const ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, detail);
            leaves[tier] = LeafOrders::make(*makeLeafGeometry(thinned, model.skeleton, model.leafMesh, crown),
                                            thinned, model.leafMesh);
            const float seen = visibleLeafLight(leafPieces(thinned, model.leafMesh, crown, appearance, 1.0f),
                                                *stencils, appearance, model.skeleton.height());
            fullTierLight = whole ? seen : fullTierLight;
            brightness = seen > 0.0f ? fullTierLight / seen : 1.0f;
        }
        states[tier] = new osg::StateSet;
        states[tier]->addUniform(new osg::Uniform("unitRows", layout.rows));
        states[tier]->addUniform(new osg::Uniform("leafBrightness", brightness));
        states[tier]->addUniform(new osg::Uniform("tierColor", tierColor(static_cast<Tier>(tier))));
    }
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
    : _species(species), _meshes(sharedMeshes(model, appearance)) {}

ModelResources::ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves)
    : _species(other._species), _usesHostGeometry(true), _meshes(other._meshes), _hostBark(bark),
      _hostLeaves(leaves) {
    std::copy(std::begin(other._impostors), std::end(other._impostors), _impostors);
}

void ModelResources::loadImpostor(Tier tier, const TreeModel& model, const Appearance& appearance) {
    _impostors[static_cast<int>(tier) - branchTiers] = sharedImpostor(model, appearance, tier);
}

void ModelResources::addGLObjects(std::vector<osg::Object*>& objects) const {
    for (int tier = 0; tier < branchTiers; ++tier) {
        if (osg::Geometry* geometry = bark(static_cast<Tier>(tier)))
            objects.push_back(geometry);
        for (std::size_t order = 0; order < LeafOrders::count; ++order)
            if (osg::Geometry* geometry = leaves(static_cast<Tier>(tier), order))
                objects.push_back(geometry);
    }
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
