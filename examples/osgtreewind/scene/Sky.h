// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osg/Geometry>

/// A dome that follows the eye, at any distance, behind all else: the colours of the day, its clouds and its
/// sun, painted once into a texture.
osg::ref_ptr<osg::Geometry> createSky(const Daylight& day);

/// What the sun adds to haze, as it is written, by the way that one looks; GLSL, with the uniforms of
/// setGlow().
extern const char* const glowText;
void setGlow(osg::StateSet& state, const Daylight& day);
