// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/FloatTargetProbe.h>

#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgTreeWind {
namespace {

/// OpenGL 3.3, of which GLSL 3.30 is, draws into RGBA32F textures and reads textures in vertex shaders.
bool supportsAnglePasses(osg::State& state) {
    const osg::GLExtensions* gl = state.get<osg::GLExtensions>();
    return gl && canRunPrograms(state) && gl->isFrameBufferObjectSupported && gl->glslLanguageVersion >= 3.3f;
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
