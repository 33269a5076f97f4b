// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/State>
#include <osg/StateSet>

#include <osgUtil/StateGraph>

namespace osgTreeWind {

/// What the scene above a place says of light, for shaders that have no fixed functions to ask: which lights
/// are on, which fog there is, whether osgShadow's ShadowMap or ViewDependentShadowMap hands shadows down,
/// and whether OpenGL encodes colours as sRGB, GL_FRAMEBUFFER_SRGB being on: then the shaders do not. A scene
/// that does so itself sets the define LINEAR_COLORS.
///
/// Known once a cull is over: ViewDependentShadowMap fills in its state last.
/// @param state to take the defines of shaders/light.glsl and shaders/scene.glsl, and no others.
/// @param samples whether fragments choose their samples: choosesSamples().
void setSceneDefines(osg::StateSet& state, const osgUtil::StateGraph* place, bool samples);

/// Whether what a camera draws into has several samples a pixel, and a fragment can choose those that it
/// covers (GL_ARB_sample_shading). Call it while the camera's frame is drawn.
bool choosesSamples(const osg::Camera& camera, const osg::State& state);

} // namespace osgTreeWind
