// SPDX-License-Identifier: MIT
#pragma once

#include "Daylight.h"

#include <osgTreeWind/nodes/Forest.h>

#include <osg/BoundingSphere>
#include <osg/Geometry>

/// Level grassland at height 0, wide enough to meet the horizon, lit by light 0 and under the fog and shadows
/// of the scene (shaders/scene.glsl).
osg::ref_ptr<osg::Geometry> createGround(const osg::BoundingSphere& bound);

/// The same grass on the ground that a forest has.
osg::ref_ptr<osg::Node> createRelief(const osgTreeWind::Forest& forest);

/// What the sky gives the ground, and all of the sun.
void setGroundLight(osg::StateSet& state, const Daylight& day);
/// The share of the sun's light that the ground below a state has.
osg::ref_ptr<osg::Uniform> sunOnGround(float share);

/// From the middle to the rim, metres.
float groundRadius(const osg::BoundingSphere& bound);
