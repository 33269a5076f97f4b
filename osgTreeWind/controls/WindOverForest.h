// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/Geometry>

/// What pictures of the wind over a forest share. Metres, the forest's coordinates.
namespace osgTreeWind {

/// From dark blue (calm) over green to yellow (20 m/s and more). @param speed m/s.
osg::Vec4 colourOfWind(float speed);
/// The height of the highest tree; of one in so many where there are very many.
float highestTree(const PlacedForest& forest);
/// 0 where there is none.
float groundAt(const ForestDescription& forest, const glm::vec2& place);
/// Makes of it lines without light that change from frame to frame, each point of a colour of its own.
void becomeLines(osg::Geometry& geometry, unsigned points, float width);

} // namespace osgTreeWind
