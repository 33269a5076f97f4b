// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/OpenGLProfile.h>

// They define the modes that the OpenGL headers of a core profile lack.
#include <osg/AlphaFunc>
#include <osg/Fog>
#include <osg/Light>
#include <osg/LineStipple>
#include <osg/Material>
#include <osg/PolygonStipple>
#include <osg/Transform>

#include <osg/VertexArrayState>

namespace osgTreeWind {

bool isCoreProfile([[maybe_unused]] const osg::State& state) {
#ifdef OSG_GL_FIXED_FUNCTION_AVAILABLE
    GLint profile = 0;
    if (state.get<osg::GLExtensions>()->glVersion >= 3.2f)
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return profile & GL_CONTEXT_CORE_PROFILE_BIT;
#else
    return true;
#endif
}

bool prepareProfile(osg::State& state) {
    if (!isCoreProfile(state))
        return false;
    if (state.getModeValidity(GL_LIGHTING)) { // not prepared yet
        for (const GLenum mode : {GL_LIGHTING, GL_FOG, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_ALPHA_TEST,
                                  GL_COLOR_MATERIAL, GL_LINE_STIPPLE, GL_POLYGON_STIPPLE})
            state.setModeValidity(mode, false);
        for (unsigned light = 0; light < 8; ++light)
            state.setModeValidity(GL_LIGHT0 + light, false);
        useCoreExtensions(*state.get<osg::GLExtensions>());
        state.setUseVertexAttributeAliasing(true);
        state.setUseModelViewAndProjectionUniforms(true);
        state.applyProjectionMatrix(new osg::RefMatrix(state.getProjectionMatrix()));
        state.applyModelViewMatrix(new osg::RefMatrix(state.getModelViewMatrix()));
    }
    osg::VertexArrayState* const current = state.getCurrentVertexArrayState();
    state.setCurrentToGlobalVertexArrayState();
    if (state.getCurrentVertexArrayState()->getVertexArrayObject() == 0)
        state.getCurrentVertexArrayState()->generateVertexArrayObject();
    state.setCurrentVertexArrayState(current);
    return true;
}

} // namespace osgTreeWind
