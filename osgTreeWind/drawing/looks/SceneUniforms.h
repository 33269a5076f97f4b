// SPDX-License-Identifier: MIT
#pragma once

#include <osg/RenderInfo>

#include <cstdint>

namespace osgTreeWind {

/// Passes the lights, fog, clip planes and shadow planes of the scene to the program in use, as uniforms of
/// shaders/core.glsl. For core profiles only: elsewhere, OpenGL passes them. Lights are those of the host's
/// uniforms `osg_LightSource[i].position` and its like, else those that the cull traversal found, else the
/// light of the osg::View. Call it in a draw, after its state is applied.
/// @param scope a number of draws with the same lights, fog and planes, which pass them to each program once;
/// 0 if others may differ.
void applySceneUniforms(osg::RenderInfo& renderInfo, std::uint64_t scope = 0);

} // namespace osgTreeWind
