// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/BoundingSphere>
#include <osg/Geometry>
#include <osg/StateSet>

/// Grassland below a forest, lit by light 0 and under the fog and shadows of the scene (shaders/scene.glsl):
/// on the ground that it has, or level at height 0. Haze hides its rim.
osg::ref_ptr<osg::Node> createGround(const osgTreeWind::Forest& forest);

/// Tufts of grass on the ground of a forest within 40 m of an eye, fewer and lower the farther. A place has
/// the same tuft whoever looks.
osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const osg::Vec3d& eye);

/// What the sky gives the ground, and all of the sun.
void setGroundLight(osg::StateSet& state, const Daylight& day);
/// The share of the sun's light that the ground below a state has.
osg::ref_ptr<osg::Uniform> sunOnGround(float share);

/// From the middle of level ground to its rim, metres.
float groundRadius(const osg::BoundingSphere& bound);
