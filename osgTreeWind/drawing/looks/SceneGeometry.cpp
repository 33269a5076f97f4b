// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SceneGeometry.h>

#include <osgTreeWind/drawing/looks/SceneUniforms.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/GLExtensions>

namespace osgTreeWind {
namespace {

/// Whether a context has no arrays, or they belong to one that no longer exists.
bool isGone(const osg::VertexArrayState* arrays) {
    return !arrays || !arrays->_stateObserverSet->getObserverdObject();
}

} // namespace

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
    const osg::VertexArrayState* arrays = _vertices[state.getContextID()].arrays;
    return isGone(arrays) || arrays->_state == &state;
}

bool SceneGeometry::bindVertices(osg::RenderInfo& renderInfo, std::uint64_t attributes) const {
    osg::State& state = *renderInfo.getState();
    auto& [arrays, known] = _vertices[state.getContextID()];
    const bool isNew = isGone(arrays);
    if (isNew) {
        arrays = createVertexArrayState(renderInfo);
        if (arrays->getVertexArrayObject() == 0)
            arrays->generateVertexArrayObject();
    }
    state.setCurrentVertexArrayState(arrays);
    state.bindVertexArrayObject(arrays);
    if (isNew)
        drawVertexArraysImplementation(renderInfo);
    const bool lacksAttributes = isNew || attributes == 0 || attributes != known;
    known = attributes;
    return lacksAttributes;
}

void SceneGeometry::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Geometry::resizeGLObjectBuffers(maxSize);
    _vertices.resize(maxSize);
}

void SceneGeometry::releaseGLObjects(osg::State* state) const {
    osg::Geometry::releaseGLObjects(state);
    for (unsigned context = 0; context < _vertices.size(); ++context)
        if (_vertices[context].arrays && (!state || state->getContextID() == context)) {
            _vertices[context].arrays->release();
            _vertices[context] = {};
        }
}

void SceneGeometry::unbindVertices(osg::State& state) {
    state.setCurrentToGlobalVertexArrayState();
    state.bindVertexArrayObject(state.getCurrentVertexArrayState());
    state.unbindVertexBufferObject(); // what OSG takes for bound
}

} // namespace osgTreeWind
