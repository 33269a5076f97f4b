// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PassState.h>

#include <osg/GLExtensions>

namespace osgTreeWind {

PassState::PassState(osg::State& state) : _state(state), _gl(*state.get<osg::GLExtensions>()) {
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING_EXT, &_formerFrameBuffer);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING_EXT, &_formerDrawFrameBuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &_formerProgram);
    glPushAttrib(GL_ALL_ATTRIB_BITS); // texture bindings and the active unit included
    _gl.glActiveTexture(GL_TEXTURE0);
    for (const GLenum mode :
         {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_ALPHA_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST,
          GL_FRAMEBUFFER_SRGB, GL_COLOR_LOGIC_OP, GL_POLYGON_STIPPLE, GL_POLYGON_OFFSET_FILL, GL_CLIP_PLANE0,
          GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5})
        glDisable(mode);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

PassState::~PassState() {
    _gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, static_cast<GLuint>(_formerFrameBuffer));
    _gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, static_cast<GLuint>(_formerDrawFrameBuffer));
    glPopAttrib(); // restores the draw buffer of the frame buffer that is bound
    _gl.glUseProgram(static_cast<GLuint>(_formerProgram));
}

void PassState::begin(osg::Program& program, osg::FrameBufferObject& target, int firstRow, int width,
                      int height) const {
    target.apply(_state);
    glViewport(0, firstRow, width, height);
    program.compileGLObjects(_state);
    _program = program.getPCP(_state);
    _program->useProgram();
}

void PassState::bind(unsigned unit, const char* sampler, osg::Texture2D* texture) const {
    _gl.glActiveTexture(GL_TEXTURE0 + unit);
    texture->apply(_state);
    set(sampler, static_cast<int>(unit));
}

void PassState::set(const char* uniform, int value) const {
    const GLint location = _program->getUniformLocation(osg::Uniform::getNameID(uniform));
    if (location >= 0)
        _gl.glUniform1i(location, value);
}

void PassState::draw() const {
    glRectf(-1.0f, -1.0f, 1.0f, 1.0f);
}

} // namespace osgTreeWind
