// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/State>
#include <osg/StateSet>

#include <osgUtil/StateGraph>

namespace osgTreeWind {

/// Passes the lighting state of the scene to shaders as defines: the lights that are on, fog, clip planes,
/// the shadow maps of osgShadow::ShadowMap, ViewDependentShadowMap and osgEarth's ShadowCaster, and whether
/// OpenGL encodes colours as sRGB (GL_FRAMEBUFFER_SRGB) instead of the shaders. A scene that encodes colours
/// itself sets LINEAR_COLORS. Call it after the cull traversal, at whose end ViewDependentShadowMap fills in
/// its state.
/// @param state receives the defines of shaders/light.glsl and shaders/scene.glsl in place of all others.
/// @param stage state set of the render stage, may be null.
/// @param stateGraph where the inherited state is read from.
/// @param sampleMask whether fragments choose their samples: supportsSampleMask().
void setSceneDefines(osg::StateSet& state, const osg::StateSet* stage, const osgUtil::StateGraph* stateGraph,
                     bool sampleMask);

/// Whether the render target of a camera is multisampled and fragments can set gl_SampleMask
/// (GL_ARB_sample_shading). Call it while the camera's frame is drawn.
bool supportsSampleMask(const osg::Camera& camera, const osg::State& state);

} // namespace osgTreeWind
