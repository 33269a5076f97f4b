// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Vec2d>
#include <osg/Vec3>
#include <osg/Vec3d>

/// Where a camera is and looks, and how: vertical field of view in degrees, width over height.
struct ForestView {
    osg::Vec3d eye, center;
};
struct Lens {
    double fieldOfView = 40.0, aspect = 16.0 / 9.0;
};

/// Of the ground at a place, in the forest's frame. @param level where there is none.
double groundHeight(const osgTreeWind::Forest& forest, const osg::Vec2d& place, double level);

/// From where a whole forest is seen: from the south-west, from above its crowns if it is wide.
/// @param radius metres.
osg::Vec3d defaultEye(const osg::Vec3d& centre, double radius, const Lens& lens);

/// As a person stands before the forest or in a gap of it, eyes 1.6 m above the ground: where trees fill the
/// picture and sky is left above them, none of them in the way, the sun rather behind than before.
ForestView viewAtEyeLevel(const osgTreeWind::Forest& forest, const Lens& lens, const osg::Vec3& toSun);

/// The tree nearest to the middle of the forest, filling the picture, from where least stands before it.
ForestView viewOfOneTree(const osgTreeWind::Forest& forest, const Lens& lens);
