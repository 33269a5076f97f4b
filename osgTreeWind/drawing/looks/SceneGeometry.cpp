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

bool SceneGeometry::canBindVertices(const osg::State& state) const {
    const osg::VertexArrayState* arrays = _vertices[state.getContextID()];
    return !arrays || arrays->_state == &state || !arrays->_stateObserverSet->getObserverdObject();
}

bool SceneGeometry::bindVertices(osg::RenderInfo& renderInfo) const {
    osg::State& state = *renderInfo.getState();
    osg::ref_ptr<osg::VertexArrayState>& arrays = _vertices[state.getContextID()];
    const bool isNew = !arrays || !arrays->_stateObserverSet->getObserverdObject(); // its context is gone
    if (isNew) {
        arrays = createVertexArrayState(renderInfo);
        if (arrays->getVertexArrayObject() == 0)
            arrays->generateVertexArrayObject();
    }
    state.setCurrentVertexArrayState(arrays);
    state.bindVertexArrayObject(arrays);
    if (isNew)
        drawVertexArraysImplementation(renderInfo);
    return isNew;
}

void SceneGeometry::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Geometry::resizeGLObjectBuffers(maxSize);
    _vertices.resize(maxSize);
}

void SceneGeometry::releaseGLObjects(osg::State* state) const {
    osg::Geometry::releaseGLObjects(state);
    for (unsigned context = 0; context < _vertices.size(); ++context)
        if (_vertices[context] && (!state || state->getContextID() == context)) {
            _vertices[context]->release();
            _vertices[context] = nullptr;
        }
}

void SceneGeometry::unbindVertices(osg::State& state) {
    state.setCurrentToGlobalVertexArrayState();
    state.bindVertexArrayObject(state.getCurrentVertexArrayState());
    state.get<osg::GLExtensions>()->glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    state.unbindVertexBufferObject(); // what OSG takes for bound
}

} // namespace osgTreeWind
