// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

/// Tufts of grass on the ground within 40 m of the eye; fewer and lower with the distance, and few under
/// closed crowns. Their positions do not depend on the eye.
osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                        const osg::Vec3d& eye);
