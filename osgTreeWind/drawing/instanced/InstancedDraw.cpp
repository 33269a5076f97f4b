// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedDraw.h>

#include <osgTreeWind/drawing/looks/SceneUniforms.h>
#include <osgTreeWind/gpu/DrawTimer.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgTreeWind {
namespace {

/// An offset into the bound buffer, as OpenGL takes it.
const char* inBuffer(GLsizeiptr offset) {
    return reinterpret_cast<const char*>(offset); // NOLINT(performance-no-int-to-ptr): OpenGL asks for it
}

constexpr unsigned instanceAttributes = sizeof(TreeInstance) / (4 * sizeof(float));

} // namespace

InstancedDraw::InstancedDraw() {
    setSupportsDisplayList(false);
    setCullingActive(false);
}

void InstancedDraw::set(osg::Geometry* geometry, InstanceList* trees, bool flush) {
    _geometry = geometry;
    _trees = trees;
    _flush = flush;
}

void InstancedDraw::drawImplementation(osg::RenderInfo& renderInfo) const {
    osg::State& state = *renderInfo.getState();
    static const ExceptionGuard guard;
    guard.run("trees may be missing in pictures", [&] { drawTrees(renderInfo); });
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    for (unsigned i = 0; i < instanceAttributes; ++i) {
        gl.glVertexAttribDivisor(treePlaceLocation + i, 0);
        gl.glDisableVertexAttribArray(treePlaceLocation + i);
    }
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    if (_flush)
        glFlush();
}

void InstancedDraw::drawTrees(osg::RenderInfo& renderInfo) const {
    osg::State& state = *renderInfo.getState();
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    const bool isCore = prepareProfile(state);
    state.setCurrentToGlobalVertexArrayState(); // the bound one belongs to the geometry of the previous draw
    state.bindVertexArrayObject(state.getCurrentVertexArrayState());
    if (_trees->page) {
        const DrawTimer time(renderInfo, "Forest pose");
        _trees->passes->apply(state, *_trees->page);
    }
    const DrawTimer time(renderInfo, "Forest draw");
    if (isCore)
        applySceneUniforms(renderInfo);
    if (const osg::Program::PerContextProgram* program = state.getLastAppliedProgramObject()) {
        static const unsigned name = osg::Uniform::getNameID("flutterPhases");
        const GLint location = program->getUniformLocation(name);
        if (location >= 0)
            gl.glUniform3fv(location, 1, _trees->flutter.ptr());
    }

    _geometry->drawVertexArraysImplementation(renderInfo);
    osg::GLBufferObject* instances = _trees->values->getOrCreateGLBufferObject(state.getContextID());
    state.bindVertexBufferObject(instances);
    const char* offset = inBuffer(instances->getOffset(_trees->values->getBufferIndex()));
    for (unsigned i = 0; i < instanceAttributes; ++i) {
        gl.glEnableVertexAttribArray(treePlaceLocation + i);
        gl.glVertexAttribPointer(treePlaceLocation + i, 4, GL_FLOAT, GL_FALSE, sizeof(TreeInstance),
                                 offset + i * 4 * sizeof(float));
        gl.glVertexAttribDivisor(treePlaceLocation + i, 1);
    }

    const auto count = static_cast<GLsizei>(_trees->size());
    for (const osg::ref_ptr<osg::PrimitiveSet>& set : _geometry->getPrimitiveSetList()) {
        if (osg::DrawElements* elements = set->getDrawElements()) {
            osg::GLBufferObject* buffer = elements->getOrCreateGLBufferObject(state.getContextID());
            const void* indices = elements->getDataPointer();
            if (buffer) {
                state.bindElementBufferObject(buffer);
                indices = inBuffer(buffer->getOffset(elements->getBufferIndex()));
            }
            gl.glDrawElementsInstanced(elements->getMode(), static_cast<GLsizei>(elements->getNumIndices()),
                                       elements->getDataType(), indices, count);
        } else if (const auto* array = dynamic_cast<const osg::DrawArrays*>(set.get())) {
            gl.glDrawArraysInstanced(array->getMode(), array->getFirst(), array->getCount(), count);
        }
    }
}

} // namespace osgTreeWind
