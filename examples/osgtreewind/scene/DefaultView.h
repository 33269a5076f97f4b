// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Vec2d>
#include <osg/Vec3>
#include <osg/Vec3d>

/// Position of a camera, and the point that it looks at.
struct ForestView {
    osg::Vec3d eye, center;
};
struct Lens {
    double fieldOfView = 40.0;  ///< Vertical, degrees.
    double aspect = 16.0 / 9.0; ///< Width over height.
};

/// Height of the ground at a place, in the scene. @param level returned where there is no ground.
double groundHeight(const osgTreeWind::Forest& forest, const osg::Vec2d& place, double level);

/// Viewpoint for a whole forest: from the south-west, above the crowns if the forest is wide.
/// @param radius metres.
osg::Vec3d defaultEye(const osg::Vec3d& centre, double radius, const Lens& lens);

/// View at eye level, 1.6 m above the ground, before the forest or in a gap: trees fill the picture with sky
/// above them, no tree is in the way, and the sun is rather behind the camera.
ForestView viewAtEyeLevel(const osgTreeWind::Forest& forest, const Lens& lens, const osg::Vec3& toSun);

/// View of the tree nearest to the middle of the forest, from the side with the fewest obstacles.
ForestView viewOfOneTree(const osgTreeWind::Forest& forest, const Lens& lens);
