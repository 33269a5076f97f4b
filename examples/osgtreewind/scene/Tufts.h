// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

/// Tufts of grass on the ground of a forest within 40 m of an eye, fewer and lower the farther. A place has
/// the same tuft whoever looks.
osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const osg::Vec3d& eye);
