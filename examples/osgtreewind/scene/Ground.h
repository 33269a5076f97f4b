// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/BoundingSphere>
#include <osg/StateSet>

#include <string>

/// Grassland below a forest, lit by light 0 and under the fog and shadows of the scene (shaders/scene.glsl):
/// on the ground that it has, or level at height 0. Haze hides its rim.
osg::ref_ptr<osg::Node> createGround(const osgTreeWind::Forest& forest);

/// How its grass looks. @param define TUFTS: a vertex is one of a blade of grass, with how far up that is, 0
/// to 1, and a number of its own, as texture coordinates.
osg::ref_ptr<osg::StateSet> createGrassState(const osgTreeWind::Forest& forest,
                                             const std::string& define = "");

/// What the sky gives the ground, and all of the sun.
void setGroundLight(osg::StateSet& state, const Daylight& day);
/// The share of the sun's light that the ground below a state has.
osg::ref_ptr<osg::Uniform> sunOnGround(float share);

/// From the middle of level ground to its rim, metres.
float groundRadius(const osg::BoundingSphere& bound);
