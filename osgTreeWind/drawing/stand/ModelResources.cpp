// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/ModelResources.h>

#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/drawing/stand/TreeGeometry.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <algorithm>
#include <iterator>

namespace osgTreeWind {

ModelResources::ModelResources(const TreeModel& model, std::size_t species, const Appearance& appearance)
    : _species(species) {
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(appearance.leafForm));
    const PoseLayout layout(model.skeleton.units.size());
    const std::vector<LeafStencils> stencils = LeafStencils::ofAtlas(*leafImage(appearance));
    float inFull = 0.0f; // light on its leaves
    for (int tier = 0; tier < branchTiers; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        const TreeDetail detail = TreeDetail::reduced(tier);
        _bark[tier] = makeSkinGeometry(whole ? model.skin : thinnedSkin(model.skeleton, detail), crown);
        if (tier == static_cast<int>(Tier::Sprays))
            _leaves[tier] = _leaves[static_cast<int>(Tier::Full)];
        float brightness = 1.0f;
        if (tier != static_cast<int>(Tier::Sprays) && !model.leaves.empty()) {
            const ThinnedLeaves thinned = thinnedLeaves(model.leaves, model.leafMesh, detail);
            _leaves[tier] =
                LeafOrders::make(*makeLeafGeometry(thinned, model.leafMesh, crown), thinned, model.leafMesh);
            const float seen = seenLeafLight(leafPieces(thinned, model.leafMesh, crown, appearance, 1.0f),
                                             stencils, appearance, model.skeleton.height());
            inFull = whole ? seen : inFull;
            brightness = seen > 0.0f ? inFull / seen : 1.0f;
        }
        _states[tier] = new osg::StateSet;
        _states[tier]->addUniform(new osg::Uniform("leafBrightness", brightness));
        _states[tier]->addUniform(new osg::Uniform("unitRows", layout.rows));
        _states[tier]->addUniform(new osg::Uniform("tierColor", tierColor(static_cast<Tier>(tier))));
    }
}

ModelResources::ModelResources(const ModelResources& other, osg::Geometry* bark, osg::Geometry* leaves)
    : _species(other._species), _isOfHost(true) {
    for (int tier = 0; tier < branchTiers; ++tier) {
        _bark[tier] = bark;
        _leaves[tier].fill(leaves);
        _states[tier] = other._states[tier];
    }
    std::copy(std::begin(other._impostors), std::end(other._impostors), _impostors);
}

void ModelResources::paint(Tier tier, const TreeModel& model, const Appearance& appearance,
                           osg::Program* program) {
    ImpostorSettings settings;
    settings.leaves = leavesOn(tier);
    osg::ref_ptr<ImpostorStrip> impostor =
        new ImpostorStrip(paintImpostor(model, appearance, settings), program);
    impostor->stateSet()->addUniform(new osg::Uniform("tierColor", tierColor(tier)));
    _impostors[static_cast<int>(tier) - branchTiers] = impostor;
}

void ModelResources::addGLObjects(std::vector<osg::Object*>& objects) const {
    for (int tier = 0; tier < branchTiers; ++tier) {
        if (_bark[tier])
            objects.push_back(_bark[tier]);
        for (const osg::ref_ptr<osg::Geometry>& leaves : _leaves[tier])
            if (leaves)
                objects.push_back(leaves);
    }
    for (const osg::ref_ptr<ImpostorStrip>& impostor : _impostors)
        if (impostor)
            objects.insert(objects.end(), {impostor->geometry(), impostor->straight(), impostor->stateSet()});
}

} // namespace osgTreeWind
