// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

/// Tufts of grass on the ground of a forest within 40 m of an eye. There are fewer and lower ones farther
/// away, and few where crowns close. At a place stands the same tuft wherever the eye is.
osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                        const osg::Vec3d& eye);
