// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SceneGeometry.h>

#include <osgTreeWind/drawing/looks/SceneUniforms.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/GLExtensions>

namespace osgTreeWind {

SceneGeometry::SceneGeometry(osg::Program* program) : _program(program) {
    setUseDisplayList(false);
    setUseVertexBufferObjects(true);
}

void SceneGeometry::drawImplementation(osg::RenderInfo& renderInfo) const {
    osg::State& state = *renderInfo.getState();
    if (!isCoreProfile(state))
        return osg::Geometry::drawImplementation(renderInfo);
    const bool usesOwn = _program && !state.getLastAppliedProgramObject();
    if (usesOwn) {
        _program->apply(state);
        state.applyModelViewAndProjectionUniformsIfRequired();
    }
    applySceneUniforms(renderInfo);
    osg::Geometry::drawImplementation(renderInfo);
    if (usesOwn) {
        state.get<osg::GLExtensions>()->glUseProgram(0);
        state.setLastAppliedProgramObject(nullptr);
    }
}

} // namespace osgTreeWind
