// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/ModelMeshes.h>

#include <osgTreeWind/drawing/stand/TreeGeometry.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/gpu/SharedObjects.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <utility>

namespace osgTreeWind {

ModelMeshes::ModelMeshes(const TreeModel& model, LeafForm leafForm) {
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(leafForm));
    const PoseLayout layout(model.skeleton.units.size());
    for (int tier = 0; tier < branchTiers; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        const TreeDetail detail = TreeDetail::reduced(tier);
        bark[tier] = makeSkinGeometry(whole ? model.skin : thinnedSkin(model.skeleton, detail), crown);
        if (tier == static_cast<int>(Tier::Sprays))
            leaves[tier] = leaves[static_cast<int>(Tier::Full)];
        else if (!model.leaves.empty()) {
            const ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, detail);
            leaves[tier] =
                LeafOrders::make(*makeLeafGeometry(thinned, model.leafMesh, crown), thinned, model.leafMesh);
        }
        states[tier] = new osg::StateSet;
        states[tier]->addUniform(new osg::Uniform("unitRows", layout.rows));
        states[tier]->addUniform(new osg::Uniform("tierColor", tierColor(static_cast<Tier>(tier))));
    }
}

osg::ref_ptr<ModelMeshes> sharedMeshes(const TreeModel& model, LeafForm leaves) {
    static SharedObjects<std::pair<std::uint64_t, LeafForm>, ModelMeshes> meshes;
    const auto make = [&] { return osg::ref_ptr<ModelMeshes>(new ModelMeshes(model, leaves)); };
    return model.identity == 0 ? make() : meshes.get({model.identity, leaves}, make);
}

} // namespace osgTreeWind
