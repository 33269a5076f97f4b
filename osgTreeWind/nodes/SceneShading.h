// SPDX-License-Identifier: MIT
#pragma once

#include <osg/StateSet>

#include <osgUtil/StateGraph>

namespace osgTreeWind {

/// What the scene above a place says of light, for shaders that have no fixed functions to ask: which lights
/// are on, which fog there is, whether osgShadow's ShadowMap or ViewDependentShadowMap hands shadows down.
///
/// Known once a cull is over: ViewDependentShadowMap fills in its state last.
/// @param state to take the defines of shaders/light.glsl and shaders/scene.glsl, and no others.
void setSceneDefines(osg::StateSet& state, const osgUtil::StateGraph* place);

} // namespace osgTreeWind
