// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3d>

/// From where a whole forest is seen: from the south-west, from above its crowns if it is wide.
/// @param radius metres. @param aspect width over height. @param fieldOfView vertical, degrees.
osg::Vec3d defaultEye(const osg::Vec3d& centre, double radius, double aspect, double fieldOfView);
