// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>
#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/BoundingSphere>
#include <osg/StateSet>

#include <string>

/// Grassland around a forest and litter below it, lit by light 0 and under the fog and shadows of the scene
/// (shaders/scene.glsl): on the ground that it has, or level at height 0. Haze hides its rim.
osg::ref_ptr<osg::Node> createGround(const osgTreeWind::Forest& forest, const GroundCover& cover);

/// How its grass looks. @param define TUFTS: a vertex is one of a blade of grass, with how far up that is, 0
/// to 1, and a number of its own, as texture coordinates.
osg::ref_ptr<osg::StateSet> createGrassState(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                             const std::string& define = "");

/// What the sky gives the ground, and all of the sun.
void setGroundLight(osg::StateSet& state, const Daylight& day);
/// The share of the sun's light that the ground below a state has.
osg::ref_ptr<osg::Uniform> sunOnGround(float share);

/// From the eye to the rim of level ground, metres.
float groundRadius(const osg::BoundingSphere& bound);
