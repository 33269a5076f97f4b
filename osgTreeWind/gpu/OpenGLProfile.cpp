// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/OpenGLProfile.h>

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

namespace {

/// Makes arrays use the attribute locations of the state. OSG 3.6.5 keeps their former ones after
/// State::resetVertexAttributeAlias(), which osgEarth calls.
void followAliases(osg::State& state, osg::VertexArrayState& arrays) {
    const unsigned normals = state.getNormalAlias()._location;
    if (normals < arrays._vertexAttribArrays.size() &&
        arrays._normalArray == arrays._vertexAttribArrays[normals])
        return;
    state.bindVertexArrayObject(&arrays);
    arrays.lazyDisablingOfVertexAttributes();
    arrays.applyDisablingOfVertexAttributes(state);
    arrays._vertexArray = arrays._normalArray = arrays._colorArray = nullptr;
    arrays._secondaryColorArray = arrays._fogCoordArray = nullptr;
    arrays._texCoordArrays.clear();
    arrays.assignAllDispatchers();
}

} // namespace

bool prepareProfile(osg::State& state) {
    if (!isCoreProfile(state))
        return false;
    if (state.getModeValidity(GL_LIGHTING)) { // not prepared yet
        useCoreExtensions(*state.get<osg::GLExtensions>());
        useCoreState(state);
        state.applyProjectionMatrix(new osg::RefMatrix(state.getProjectionMatrix()));
        state.applyModelViewMatrix(new osg::RefMatrix(state.getModelViewMatrix()));
    }
    osg::VertexArrayState* const current = state.getCurrentVertexArrayState();
    state.setCurrentToGlobalVertexArrayState();
    if (state.getCurrentVertexArrayState()->getVertexArrayObject() == 0)
        state.getCurrentVertexArrayState()->generateVertexArrayObject();
    followAliases(state, *state.getCurrentVertexArrayState());
    state.setCurrentVertexArrayState(current);
    return true;
}

} // namespace osgTreeWind
