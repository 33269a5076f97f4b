// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/Geometry>

/// Functions shared by WindArrows and WindStreaks. Metres, in the forest's frame.
namespace osgTreeWind {

/// Colour of a wind speed: dark blue (calm) to green to yellow (20 m/s and more). @param speed m/s.
osg::Vec4 windColour(float speed);
/// Height of the tallest tree, of a sample of some 2000 trees in large forests.
float maxTreeHeight(const PlacedForest& forest);
/// Height of the ground; 0 without a ground.
float groundHeight(const ForestDescription& forest, const glm::vec2& place);
/// Sets up a geometry for unlit lines that change in each frame, with a colour per point.
void setUpLines(osg::Geometry& geometry, unsigned points);

} // namespace osgTreeWind
