// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedDraw.h>

#include <osgTreeWind/base/Span.h>
#include <osgTreeWind/drawing/instanced/RefilledGeometry.h>
#include <osgTreeWind/drawing/looks/SceneUniforms.h>
#include <osgTreeWind/gpu/DrawTimer.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>
#include <osg/State>

#include <atomic>
#include <cstddef>
#include <cstring>

namespace osgTreeWind {
namespace {

/// An offset into the bound buffer, as OpenGL takes it.
const char* inBuffer(std::ptrdiff_t offset) {
    return reinterpret_cast<const char*>(offset); // NOLINT(performance-no-int-to-ptr): OpenGL asks for it
}

constexpr unsigned instanceAttributes = sizeof(TreeInstance) / (4 * sizeof(float));

/// Attributes with a value per instance; also 0 in place of vertices, as some drivers draw nothing without
/// it.
Span<unsigned> instanceLocations(const osg::Geometry& geometry) {
    static constexpr unsigned locations[] = {treePlaceLocation, treeSizeLocation, treeStateLocation,
                                             treeLightLocation, 0};
    return {locations, instanceAttributes + !geometry.getVertexArray()};
}

std::uint64_t nextId() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

/// Binds the indices of a geometry. @return offset of the first one.
std::ptrdiff_t bindIndices(osg::State& state, osg::DrawElements& elements) {
    osg::GLBufferObject* indices = elements.getOrCreateGLBufferObject(state.getContextID());
    state.bindElementBufferObject(indices);
    return indices->getOffset(elements.getBufferIndex());
}

} // namespace

bool hasIndirectDraws(const osg::State& state) {
    const unsigned context = state.getContextID();
    return state.get<osg::GLExtensions>()->glMultiDrawElementsIndirect &&
           osg::isGLExtensionOrVersionSupported(context, "GL_ARB_multi_draw_indirect", 4.3f) &&
           osg::isGLExtensionOrVersionSupported(context, "GL_ARB_base_instance", 4.2f);
}

DrawBuffer::DrawBuffer() : id(nextId()) {
    osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
    buffer->setUsage(GL_STREAM_DRAW_ARB);
    instances->setVertexBufferObject(buffer);
    commands->setVertexBufferObject(buffer);
}

void DrawBuffer::beginDraws(osg::State& state) {
    scope = hasHostState ? 0 : nextId();
    isCore = prepareProfile(state);
    isIndirect = hasIndirectDraws(state);
}

void DrawBuffer::releaseGLObjects(osg::State* state) {
    id = nextId();
    instances->getVertexBufferObject()->releaseGLObjects(state);
}

void DrawBuffer::clear() {
    instances->clear();
    commands->clear();
}

std::uint32_t DrawBuffer::add(const TreeInstance& tree) {
    const float* first = tree.place;
    instances->insert(instances->end(), first, first + sizeof tree / sizeof(float));
    return static_cast<std::uint32_t>(instanceCount() - 1);
}

std::uint32_t DrawBuffer::add(const DrawCommand* added, std::size_t count) {
    const std::size_t before = commands->size();
    commands->resize(before + count * sizeof *added / sizeof(GLuint));
    std::memcpy(&(*commands)[before], added, count * sizeof *added);
    return static_cast<std::uint32_t>(before * sizeof(GLuint) / sizeof *added);
}

InstancedDraw::InstancedDraw() {
    setSupportsDisplayList(false);
    setCullingActive(false);
}

void InstancedDraw::set(osg::Geometry* geometry, DrawBuffer* buffer, const DrawnPoses& poses, bool flush) {
    _geometry = geometry;
    _buffer = buffer;
    _poses = poses;
    _flush = flush;
}

void InstancedDraw::drawInstances(std::uint32_t first, std::uint32_t count) {
    _hasCommands = false;
    _first = first;
    _count = count;
}

void InstancedDraw::drawCommands(std::uint32_t first, std::uint32_t count) {
    _hasCommands = true;
    _first = first;
    _count = count;
}

void InstancedDraw::drawImplementation(osg::RenderInfo& renderInfo) const {
    osg::State& state = *renderInfo.getState();
    const auto* withObject = dynamic_cast<const SceneGeometry*>(_geometry.get()); // null for that of hosts
    if (withObject && !withObject->canBindVertices(state))
        withObject = nullptr;
    static const ExceptionGuard guard;
    guard.run("trees may be missing in pictures", [&] { drawTrees(renderInfo, withObject); });
    SceneGeometry::unbindVertices(state);
    if (!withObject)
        unbindArrays(state);
    if (_flush)
        glFlush();
}

void InstancedDraw::drawTrees(osg::RenderInfo& renderInfo, const SceneGeometry* withObject) const {
    osg::State& state = *renderInfo.getState();
    const bool isCore = _buffer->isCore && prepareProfile(state);
    if (_poses.page) {
        const DrawTimer time(renderInfo, "Forest pose");
        _buffer->poses->prepareBound(state, *_poses.page);
    }
    const DrawTimer time(renderInfo, "Forest draw");
    if (isCore)
        applySceneUniforms(renderInfo, _buffer->scope);
    if (const osg::Program::PerContextProgram* program = state.getLastAppliedProgramObject()) {
        static const unsigned name = osg::Uniform::getNameID("flutterPhases");
        const GLint location = program->getUniformLocation(name);
        if (location >= 0)
            state.get<osg::GLExtensions>()->glUniform3fv(location, 1, _poses.flutter.ptr());
    }
    bindArrays(renderInfo, withObject);
    if (_hasCommands)
        drawParts(state);
    else
        drawWhole(state);
}

void InstancedDraw::bindArrays(osg::RenderInfo& renderInfo, const SceneGeometry* withObject) const {
    osg::State& state = *renderInfo.getState();
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    if (const auto* refilled = dynamic_cast<const RefilledGeometry*>(_geometry.get()))
        refilled->fillBuffers(state);
    osg::GLBufferObject* buffer = _buffer->instances->getOrCreateGLBufferObject(state.getContextID());
    if (buffer->isDirty()) {
        buffer->compileBuffer();
        gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    }
    const bool isFixed = _hasCommands && _buffer->isIndirect; // commands have the first instance
    if (withObject) {
        if (!withObject->bindVertices(renderInfo, isFixed ? _buffer->id : 0))
            return;
    } else {
        state.setCurrentToGlobalVertexArrayState(); // that of the previous draw belongs to its geometry
        state.bindVertexArrayObject(state.getCurrentVertexArrayState());
        _geometry->drawVertexArraysImplementation(renderInfo);
    }
    for (const unsigned location : instanceLocations(*_geometry)) {
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribDivisor(location, 1);
    }
    setInstances(state, 0);
}

/// Leaves the vertex array object that OSG shares between geometries as it expects it.
void InstancedDraw::unbindArrays(osg::State& state) const {
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    for (const unsigned location : instanceLocations(*_geometry)) {
        gl.glVertexAttribDivisor(location, 0);
        gl.glDisableVertexAttribArray(location);
    }
    state.unbindElementBufferObject();
}

/// Sets the first instance of the next draw.
void InstancedDraw::setInstances(const osg::State& state, std::uint32_t first) const {
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    const osg::GLBufferObject* buffer = _buffer->instances->getGLBufferObject(state.getContextID());
    const std::ptrdiff_t offset =
        buffer->getOffset(_buffer->instances->getBufferIndex()) + first * sizeof(TreeInstance);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, buffer->getGLObjectID());
    std::ptrdiff_t attribute = 0; // the one in place of vertices may have any value
    for (const unsigned location : instanceLocations(*_geometry))
        gl.glVertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, sizeof(TreeInstance),
                                 inBuffer(offset + attribute++ % instanceAttributes * 4 * sizeof(float)));
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
}

void InstancedDraw::drawParts(osg::State& state) const {
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    osg::DrawElements& elements = *_geometry->getPrimitiveSet(0)->getDrawElements();
    const std::ptrdiff_t indices = bindIndices(state, elements);
    if (_buffer->isIndirect) {
        const osg::GLBufferObject* buffer = _buffer->commands->getGLBufferObject(state.getContextID());
        gl.glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer->getGLObjectID());
        const std::ptrdiff_t offset = buffer->getOffset(_buffer->commands->getBufferIndex());
        gl.glMultiDrawElementsIndirect(elements.getMode(), elements.getDataType(),
                                       inBuffer(offset + _first * sizeof(DrawCommand)),
                                       static_cast<GLsizei>(_count), 0);
        gl.glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
        return;
    }
    const std::ptrdiff_t indexSize = elements.getDataType() == GL_UNSIGNED_SHORT ? 2 : 4;
    const auto* first = reinterpret_cast<const DrawCommand*>(_buffer->commands->getDataPointer()) + _first;
    for (const DrawCommand* each = first; each != first + _count; ++each) {
        if (each[0].firstInstance != (each == first ? 0 : each[-1].firstInstance))
            setInstances(state, each->firstInstance);
        gl.glDrawElementsInstancedBaseVertex(elements.getMode(), static_cast<GLsizei>(each->indices),
                                             elements.getDataType(),
                                             inBuffer(indices + each->firstIndex * indexSize),
                                             static_cast<GLsizei>(each->instances), each->firstVertex);
    }
}

void InstancedDraw::drawWhole(osg::State& state) const {
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    if (_first > 0)
        setInstances(state, _first);
    const auto count = static_cast<GLsizei>(_count);
    for (const osg::ref_ptr<osg::PrimitiveSet>& set : _geometry->getPrimitiveSetList()) {
        if (osg::DrawElements* elements = set->getDrawElements()) {
            const void* indices = elements->getDataPointer();
            if (elements->getOrCreateGLBufferObject(state.getContextID()))
                indices = inBuffer(bindIndices(state, *elements));
            gl.glDrawElementsInstanced(elements->getMode(), static_cast<GLsizei>(elements->getNumIndices()),
                                       elements->getDataType(), indices, count);
        } else if (const auto* array = dynamic_cast<const osg::DrawArrays*>(set.get())) {
            gl.glDrawArraysInstanced(array->getMode(), array->getFirst(), array->getCount(), count);
        }
    }
}

} // namespace osgTreeWind
