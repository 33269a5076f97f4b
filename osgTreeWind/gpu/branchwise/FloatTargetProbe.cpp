// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/FloatTargetProbe.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>
#include <osg/State>
#include <osg/Texture>

namespace osgTreeWind {
namespace {

bool hasFloatTargets(const osg::GLExtensions& gl) {
    GLint boundFramebuffer = 0, boundTexture = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING_EXT, &boundFramebuffer);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &boundTexture);
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F_ARB, 4, 4, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.glGenFramebuffers(1, &framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, framebuffer);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture, 0);
    const bool complete = gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, static_cast<GLuint>(boundFramebuffer));
    gl.glDeleteFramebuffers(1, &framebuffer);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(boundTexture));
    glDeleteTextures(1, &texture);
    return complete && glGetError() == GL_NO_ERROR;
}

bool supportsAnglePasses(osg::State& state) {
    const osg::GLExtensions* gl = state.get<osg::GLExtensions>();
    GLint vertexTextures = 0;
    glGetIntegerv(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, &vertexTextures);
    return gl && canRunPrograms(state) && gl->isFrameBufferObjectSupported &&
           gl->glslLanguageVersion >= 3.3f && vertexTextures > 2 &&
           osg::isGLExtensionOrVersionSupported(state.getContextID(), "GL_ARB_texture_float", 3.0f) &&
           hasFloatTargets(*gl);
}

} // namespace

FloatTargetProbe::FloatTargetProbe() {
    setSupportsDisplayList(false);
    setCullingActive(false);
}

FloatTargetProbe::FloatTargetProbe(const FloatTargetProbe& other, const osg::CopyOp& copyop)
    : osg::Drawable(other, copyop), _answer(other.answer()) {}

void FloatTargetProbe::drawImplementation(osg::RenderInfo& renderInfo) const {
    if (_answer == NOT_KNOWN_YET)
        _answer = supportsAnglePasses(*renderInfo.getState()) ? SUPPORTED : MISSING;
}

} // namespace osgTreeWind
