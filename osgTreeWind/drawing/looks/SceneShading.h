// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
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
/// @param multisampled whether alpha becomes coverage: isMultisampled().
void setSceneDefines(osg::StateSet& state, const osgUtil::StateGraph* place, bool multisampled = false);

/// Whether what a camera draws into has several samples a pixel. Call it while its frame is drawn.
bool isMultisampled(const osg::Camera& camera);

/// Lets alpha be coverage for setSceneDefines() to use; nothing changes where there is one sample a pixel.
void setCoverageModes(osg::StateSet& state);

} // namespace osgTreeWind
