// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osg/Geometry>

/// The text of a function `vec3 glow(vec3 way)` of shaders, what the sun adds to haze that is looked at that
/// way, and of the uniforms it takes: setSkyUniforms().
extern const char* const glowText;
void setSkyUniforms(osg::StateSet& state, const Daylight& day);

/// Covers the screen behind everything, after the opaque things, and has no extent of its own.
osg::ref_ptr<osg::Geometry> createSky();
