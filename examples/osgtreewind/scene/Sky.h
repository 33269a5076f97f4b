// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osg/Geometry>

/// Sky dome behind everything else that follows the eye: colours of the day, clouds and sun, painted once
/// into a texture.
osg::ref_ptr<osg::Geometry> createSky(const Daylight& day);

/// Sets the uniforms of shaders/glow.glsl.
void setGlow(osg::StateSet& state, const Daylight& day);
