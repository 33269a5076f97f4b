// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/StandShape.h>

#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/nodes/TreeGeometry.h>

namespace osgTreeWind {

StandShape::StandShape(const TreeModel& model, std::size_t species, const Appearance& appearance,
                       const ForestDrawing& drawing, osg::Program* impostorProgram)
    : _species(species), _state(new osg::StateSet) {
    const CrownEllipsoid crown(model.leaves);
    const TreeDetail details[tierCount - 1] = {TreeDetail::full(), TreeDetail::reducedOnce(),
                                               TreeDetail::reducedTwice()};
    for (int tier = 0; tier < tierCount - 1; ++tier) {
        const bool whole = tier == static_cast<int>(Tier::Full);
        _bark[tier] =
            makeSkinGeometry(whole ? model.skin : makeBranchSkin(model.skeleton, details[tier].skin));
        if (!model.leaves.empty())
            _leaves[tier] = makeLeafGeometry(thinnedLeaves(model.leaves, model.leafMesh, details[tier]),
                                             model.leafMesh, crown);
    }
    if (drawing.tiers && drawing.impostor > 0.0f) {
        ImpostorSettings settings;
        _impostor = new ImpostorShape(paintImpostor(model, appearance, settings), impostorProgram);
    }
    const PoseLayout layout(model.skeleton.units.size());
    _state->addUniform(new osg::Uniform("unitWidth", layout.width));
    _state->addUniform(new osg::Uniform("unitRows", layout.rows));
}

StandShape::StandShape(const StandShape& other, osg::Geometry* bark, osg::Geometry* leaves)
    : _species(other._species), _impostor(other._impostor), _state(other._state) {
    for (int tier = 0; tier < tierCount - 1; ++tier) {
        _bark[tier] = bark;
        _leaves[tier] = leaves;
    }
}

void StandShape::resizeGLObjectBuffers(unsigned maxSize) const {
    for (int tier = 0; tier < tierCount - 1; ++tier)
        for (const osg::ref_ptr<osg::Geometry>& geometry : {_bark[tier], _leaves[tier]})
            if (geometry)
                geometry->resizeGLObjectBuffers(maxSize);
    if (_impostor) {
        _impostor->geometry()->resizeGLObjectBuffers(maxSize);
        _impostor->stateSet()->resizeGLObjectBuffers(maxSize);
    }
}

void StandShape::releaseGLObjects(osg::State* state) const {
    for (int tier = 0; tier < tierCount - 1; ++tier)
        for (const osg::ref_ptr<osg::Geometry>& geometry : {_bark[tier], _leaves[tier]})
            if (geometry)
                geometry->releaseGLObjects(state);
    if (_impostor) {
        _impostor->geometry()->releaseGLObjects(state);
        _impostor->stateSet()->releaseGLObjects(state);
    }
}

} // namespace osgTreeWind
