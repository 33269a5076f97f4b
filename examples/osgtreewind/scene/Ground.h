// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>
#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/BoundingSphere>
#include <osg/StateSet>

#include <string>

/// Makes grassland around a forest and litter below it, on the forest's ground or level at height 0. It is
/// lit by light 0 with the fog and shadows of the scene (shaders/scene.glsl). Haze hides its edge.
osg::ref_ptr<osg::Node> createGround(const osgTreeWind::Forest& forest, const GroundCover& cover);

/// State set of the grass. @param define "#define TUFTS": vertices are those of grass and herbs. Their
/// texture coordinates are the position along the blade (0 to 1), a random number, plus 1 on herbs, and the
/// height of the plant.
osg::ref_ptr<osg::StateSet> createGrassState(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                             const std::string& define = "");

/// Sets the light of the sky on the ground.
void setGroundLight(osg::StateSet& state, const Daylight& day);

/// Distance from the eye to the edge of level ground, metres.
float groundRadius(const osg::BoundingSphere& bound);
