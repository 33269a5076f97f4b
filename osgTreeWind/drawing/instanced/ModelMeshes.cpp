// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ModelMeshes.h>

#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/gpu/SharedObjects.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <string>
#include <tuple>
#include <utility>

namespace osgTreeWind {

ModelMeshes::ModelMeshes(const TreeModel& model, const Appearance& appearance) {
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(appearance.leafForm));
    const PoseLayout layout(model.skeleton.units.size());
    stencils = LeafStencils::ofAtlas(leafImage(appearance));
    float inFull = 0.0f; // light on its leaves
    for (int tier = 0; tier < branchTiers; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        const TreeDetail detail = TreeDetail::reduced(tier);
        bark[tier] = makeSkinGeometry(whole ? model.skin : thinnedSkin(model.skeleton, detail), crown);
        float brightness = 1.0f;
        if (tier == static_cast<int>(Tier::Sprays)) {
            leaves[tier] = leaves[static_cast<int>(Tier::Full)];
        } else if (!model.leaves.empty()) {
            const ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, detail);
            leaves[tier] =
                LeafOrders::make(*makeLeafGeometry(thinned, model.leafMesh, crown), thinned, model.leafMesh);
            const float seen = seenLeafLight(leafPieces(thinned, model.leafMesh, crown, appearance, 1.0f),
                                             *stencils, appearance, model.skeleton.height());
            inFull = whole ? seen : inFull;
            brightness = seen > 0.0f ? inFull / seen : 1.0f;
        }
        states[tier] = new osg::StateSet;
        states[tier]->addUniform(new osg::Uniform("unitRows", layout.rows));
        states[tier]->addUniform(new osg::Uniform("leafBrightness", brightness));
        states[tier]->addUniform(new osg::Uniform("tierColor", tierColor(static_cast<Tier>(tier))));
    }
}

osg::ref_ptr<ModelMeshes> sharedMeshes(const TreeModel& model, const Appearance& appearance) {
    using Cards = std::tuple<LeafForm, std::string, float>; // and what their light follows from
    static SharedObjects<std::pair<std::uint64_t, Cards>, ModelMeshes> meshes;
    const auto make = [&] { return osg::ref_ptr<ModelMeshes>(new ModelMeshes(model, appearance)); };
    const Cards cards{appearance.leafForm, appearance.leafImage, appearance.underside};
    return model.identity == 0 ? make() : meshes.get({model.identity, cards}, make);
}

} // namespace osgTreeWind
