// SPDX-License-Identifier: MIT
#pragma once

#include <osg/GLExtensions>
#include <osg/State>
// They define the modes that the OpenGL headers of a core profile lack.
#include <osg/AlphaFunc>
#include <osg/Fog>
#include <osg/Light>
#include <osg/LineStipple>
#include <osg/Material>
#include <osg/PolygonStipple>
#include <osg/Transform>

// The headers of Windows are those of OpenGL 1.1, and OSG does not define these.
#ifndef GL_ACTIVE_TEXTURE
#define GL_ACTIVE_TEXTURE 0x84E0
#endif
#ifndef GL_VERTEX_ARRAY_BINDING
#define GL_VERTEX_ARRAY_BINDING 0x85B5
#endif
#ifndef GL_CONTEXT_PROFILE_MASK
#define GL_CONTEXT_PROFILE_MASK 0x9126
#define GL_CONTEXT_CORE_PROFILE_BIT 0x00000001
#endif

namespace osgTreeWind {

/// Whether the current context, which `state` belongs to, is used as an OpenGL core profile: it has one, or
/// OSG is built without the fixed function.
bool isCoreProfile(const osg::State& state);

/// Corrects what an OSG that is not built for core profiles takes for missing there, as extensions that
/// became part of OpenGL are not listed.
inline void useCoreExtensions(osg::GLExtensions& extensions) {
    extensions.isShadowSupported = true;
    extensions.preferGenerateMipmapSGISForPowerOfTwo = false;
}

/// Makes OSG use generic vertex attributes and matrices as uniforms, and no modes of the fixed function.
inline void useCoreState(osg::State& state) {
    for (const GLenum mode : {GL_LIGHTING, GL_FOG, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_ALPHA_TEST,
                              GL_COLOR_MATERIAL, GL_LINE_STIPPLE, GL_POLYGON_STIPPLE})
        state.setModeValidity(mode, false);
    for (unsigned light = 0; light < 8; ++light)
        state.setModeValidity(GL_LIGHT0 + light, false);
    state.setUseVertexAttributeAliasing(true);
    state.setUseModelViewAndProjectionUniforms(true);
}

/// Makes OSG's state fit for a core profile if the current context has one: useCoreExtensions(),
/// useCoreState(), and a vertex array object for drawables without one. An OSG that is built for core
/// profiles (OPENGL_PROFILE=GLCORE) has done most of this; Debian's has not.
/// @return isCoreProfile().
bool prepareProfile(osg::State& state);

/// An attribute that only a compatibility profile has, such as osg::Light. In a core profile it is not
/// applied, but shaders may get its values (drawing/looks/SceneUniforms.h).
template <typename Attribute>
class CompatibilityOnly : public Attribute {
public:
    using Attribute::Attribute;
    osg::Object* cloneType() const override { return new CompatibilityOnly; }
    void apply(osg::State& state) const override {
        if (!isCoreProfile(state))
            Attribute::apply(state);
    }
};

} // namespace osgTreeWind
