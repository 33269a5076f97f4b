// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelResources.h>

#include <osgTreeWind/drawing/impostors/ImpostorCache.h>
#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/instanced/RefilledGeometry.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/looks/PaintedTexture.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/OsgConversions.h>
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

constexpr unsigned leafRecordsUnit = 15; // texture unit

osg::ref_ptr<osg::PrimitiveSet> triangles(const std::vector<unsigned>& indices, std::size_t vertices) {
    if (vertices <= 65536)
        return new osg::DrawElementsUShort(GL_TRIANGLES, indices.begin(), indices.end());
    return new osg::DrawElementsUInt(GL_TRIANGLES, indices.begin(), indices.end());
}

TierMeshes makeBarkMeshes(const TreeModel& model, const CrownShade& crown, osg::StateSet& state) {
    TierMeshes meshes;
    std::vector<BranchSkin> skins;
    std::vector<unsigned> indices;
    std::size_t vertices = 0, mostVertices = 0; // of a tier
    for (int tier = 0; tier < branchTiers; ++tier) {
        BranchSkin& skin = skins.emplace_back(tier == static_cast<int>(Tier::Full)
                                                  ? makeBranchSkin(model.skeleton)
                                                  : thinnedSkin(model.skeleton, TreeDetail::reduced(tier)));
        meshes.parts[tier] = sortIntoParts(skin, model.skeleton.height());
        for (MeshPart& part : meshes.parts[tier]) {
            part.firstIndex += static_cast<std::uint32_t>(indices.size());
            part.firstVertex = static_cast<std::int32_t>(vertices);
        }
        indices.insert(indices.end(), skin.indices.begin(), skin.indices.end());
        vertices += skin.vertices.size();
        mostVertices = std::max(mostVertices, skin.vertices.size());
    }
    meshes.geometry = makePackedBark(skins, model.skeleton, crown, state);
    meshes.geometry->addPrimitiveSet(triangles(indices, mostVertices));
    return meshes;
}

struct LeafMeshes {
    TierMeshes meshes;             ///< Without geometry.
    float brightness[branchTiers]; ///< ModelMeshes::leafBrightness.
    osg::ref_ptr<osg::Image> records;
};

LeafMeshes makeLeafMeshes(const TreeModel& model, const CrownShade& crown, const Appearance& appearance,
                          const std::vector<LeafStencils>& stencils) {
    const float coverage = leafCoverage(appearance.leafForm), height = model.skeleton.height();
    LeafMeshes leaves;
    std::vector<glm::vec4> records;
    float fullTierLight = 0.0f; // on the leaves
    for (int tier = 0; tier < branchTiers; ++tier) {
        if (tier == static_cast<int>(Tier::Sprays)) {
            leaves.meshes.parts[tier] = leaves.meshes.parts[static_cast<int>(Tier::Full)];
            leaves.brightness[tier] = 1.0f;
            continue;
        }
        ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, TreeDetail::reduced(tier));
        const float seen = visibleLeafLight(leafPieces(thinned, model.leafMesh, crown, appearance, 1.0f),
                                            stencils, appearance, height);
        fullTierLight = tier == static_cast<int>(Tier::Full) ? seen : fullTierLight;
        leaves.brightness[tier] = seen > 0.0f ? fullTierLight / seen : 1.0f;
        leaves.meshes.parts[tier] = sortIntoParts(thinned, model.leafMesh, coverage, height);
        for (MeshPart& part : leaves.meshes.parts[tier])
            part.firstVertex = static_cast<int>(4 * records.size() / leafRecordTexels);
        addLeafRecords(thinned, model.skeleton, model.leafMesh, crown, records);
    }
    const DataTexture texture("leaf records", records.size());
    texture.write(records);
    leaves.records = texture.texture()->getImage();
    return leaves;
}

void setLeafState(osg::StateSet& state, const TreeModel& model, osg::Texture2D* records) {
    setFloatFormat(*records);
    bindDataTexture(state, "leafRecords", leafRecordsUnit, records);
    osg::ref_ptr<osg::Uniform> corners =
        new osg::Uniform(osg::Uniform::FLOAT_VEC3, "leafCorners", verticesPerLeafCluster);
    osg::ref_ptr<osg::Uniform> normals =
        new osg::Uniform(osg::Uniform::FLOAT_VEC3, "leafNormals", quadsPerLeafCluster);
    for (unsigned i = 0; i < verticesPerLeafCluster; ++i) {
        corners->setElement(i, toOsg(model.leafMesh[i].corner));
        normals->setElement(i / 4, toOsg(model.leafMesh[i].normal));
    }
    state.addUniform(corners);
    state.addUniform(normals);
}

} // namespace

ModelMeshes::ModelMeshes(const std::shared_ptr<const TreeModel>& model, const Appearance& appearance)
    : state(new osg::StateSet), stencils(LeafStencils::ofAtlas(leafImage(appearance))) {
    const auto makeCrown = [model, coverage = leafCoverage(appearance.leafForm)] {
        return CrownShade(model->leaves, model->leafMesh, coverage);
    };
    const CrownShade crown = makeCrown();
    bark = makeBarkMeshes(*model, crown, *state);
    bark.geometry = new RefilledGeometry(*bark.geometry, [model, makeCrown] {
        const osg::ref_ptr<osg::StateSet> unused = new osg::StateSet;
        return makeBarkMeshes(*model, makeCrown(), *unused).geometry;
    });
    std::fill(std::begin(leafBrightness), std::end(leafBrightness), 1.0f);
    if (model->leaves.empty())
        return;
    const LeafMeshes made = makeLeafMeshes(*model, crown, appearance, *stencils);
    leaves = made.meshes;
    std::copy(std::begin(made.brightness), std::end(made.brightness), leafBrightness);
    const auto makeRecords = [model, makeCrown, appearance, atlas = stencils] {
        return makeLeafMeshes(*model, makeCrown(), appearance, *atlas).records;
    };
    setLeafState(*state, *model, makeLoadedTexture("leaf records", made.records, makeRecords));
    leaves.geometry = new SceneGeometry;
    leaves.geometry->setName("leaves");
    leaves.geometry->addPrimitiveSet(triangles(leafIndices(model->leaves.size()), // the most of all tiers
                                               verticesPerLeafCluster * model->leaves.size()));
}

namespace {

/// The meshes of a model; forests of the process share those of a shared model (TreeModel::identity) while
/// one of them holds them. Any thread.
osg::ref_ptr<ModelMeshes> sharedMeshes(const std::shared_ptr<const TreeModel>& model,
                                       const Appearance& appearance) {
    using Cards = std::tuple<LeafForm, std::string, float>; // the fields that meshes depend on
    static SharedObjects<std::pair<std::uint64_t, Cards>, ModelMeshes> meshes;
    const auto make = [&] { return osg::ref_ptr<ModelMeshes>(new ModelMeshes(model, appearance)); };
    const Cards cards{appearance.leafForm, appearance.leafImage, appearance.underside};
    return model->identity == 0 ? make() : meshes.get({model->identity, cards}, make);
}

} // namespace

ModelResources::ModelResources(const std::shared_ptr<const TreeModel>& model, std::size_t species,
                               const Appearance& appearance)
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
    for (osg::Geometry* geometry :
         {_meshes->bark.geometry.get(), _meshes->leaves.geometry.get(), hostBark(), hostLeaves()})
        if (geometry)
            objects.push_back(geometry);
    objects.push_back(_meshes->state);
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
            new ImpostorStrip(cachedImpostor(model, appearance, settings), program);
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
