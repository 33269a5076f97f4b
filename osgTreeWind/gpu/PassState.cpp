// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PassState.h>

#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/AlphaFunc>
#include <osg/ClipPlane>
#include <osg/PolygonStipple>

namespace osgTreeWind {

PassState::PassState(osg::State& state)
    : _state(state), _gl(*state.get<osg::GLExtensions>()), _program(state.getLastAppliedProgramObject()) {
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING_EXT, &_readFrameBuffer);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING_EXT, &_drawFrameBuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &_programHandle);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &_vertexArray);
    glGetIntegerv(GL_VIEWPORT, _viewport);
    glGetIntegerv(GL_POLYGON_MODE, _polygonMode);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &_activeTexture);
    for (unsigned unit = 0; unit < units; ++unit) {
        _gl.glActiveTexture(GL_TEXTURE0 + unit);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &_textures[unit]);
    }
    _gl.glActiveTexture(GL_TEXTURE0);
    for (const GLenum mode :
         {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB,
          GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL, GL_CLIP_PLANE0, GL_CLIP_PLANE0 + 1, GL_CLIP_PLANE0 + 2,
          GL_CLIP_PLANE0 + 3, GL_CLIP_PLANE0 + 4, GL_CLIP_PLANE0 + 5})
        disable(mode);
    if (!isCoreProfile(state)) {
        disable(GL_ALPHA_TEST);
        disable(GL_POLYGON_STIPPLE);
    }
    GLboolean (*isEnabled)(GLenum, GLuint) = nullptr; // osg::GLExtensions has neither
    void (*getBooleans)(GLenum, GLuint, GLboolean*) = nullptr;
    osg::setGLExtensionFuncPtr(isEnabled, "glIsEnabledi");
    osg::setGLExtensionFuncPtr(getBooleans, "glGetBooleani_v");
    for (GLuint i = 0; i < targets; ++i) {
        _blends[i] = isEnabled(GL_BLEND, i);
        getBooleans(GL_COLOR_WRITEMASK, i, _colorMasks[i]);
        _gl.glDisablei(GL_BLEND, i);
        _gl.glColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    _gl.glGenVertexArrays(1, &_noArrays);
    _gl.glBindVertexArray(_noArrays);
}

PassState::~PassState() {
    _gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, static_cast<GLuint>(_readFrameBuffer));
    _gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, static_cast<GLuint>(_drawFrameBuffer));
    _gl.glBindVertexArray(static_cast<GLuint>(_vertexArray));
    _gl.glDeleteVertexArrays(1, &_noArrays);
    for (unsigned unit = 0; unit < units; ++unit) {
        _gl.glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(_textures[unit]));
    }
    _gl.glActiveTexture(static_cast<GLenum>(_activeTexture));
    glViewport(_viewport[0], _viewport[1], _viewport[2], _viewport[3]);
    if (_polygonMode[0] == _polygonMode[1] || isCoreProfile(_state)) {
        glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(_polygonMode[0]));
    } else {
        glPolygonMode(GL_FRONT, static_cast<GLenum>(_polygonMode[0]));
        glPolygonMode(GL_BACK, static_cast<GLenum>(_polygonMode[1]));
    }
    for (GLuint i = 0; i < targets; ++i) {
        if (_blends[i])
            _gl.glEnablei(GL_BLEND, i);
        _gl.glColorMaski(i, _colorMasks[i][0], _colorMasks[i][1], _colorMasks[i][2], _colorMasks[i][3]);
    }
    for (const GLenum mode : _disabled)
        glEnable(mode);
    _gl.glUseProgram(static_cast<GLuint>(_programHandle));
    _state.setLastAppliedProgramObject(_program);
}

void PassState::disable(GLenum mode) {
    if (!glIsEnabled(mode))
        return;
    glDisable(mode);
    _disabled.push_back(mode);
}

void PassState::begin(osg::Program& program, osg::FrameBufferObject& target, int firstRow, int width,
                      int height) const {
    target.apply(_state);
    glViewport(0, firstRow, width, height);
    program.apply(_state);
}

void PassState::bind(unsigned unit, const char* sampler, osg::Texture2D* texture) const {
    _gl.glActiveTexture(GL_TEXTURE0 + unit);
    texture->apply(_state);
    set(sampler, static_cast<int>(unit));
}

void PassState::set(const char* uniform, int value) const {
    const osg::Program::PerContextProgram* program = _state.getLastAppliedProgramObject();
    const GLint location = program ? program->getUniformLocation(osg::Uniform::getNameID(uniform)) : -1;
    if (location >= 0)
        _gl.glUniform1i(location, value);
}

void PassState::draw() const {
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace osgTreeWind
