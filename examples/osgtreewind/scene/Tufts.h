// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

/// Plants on the ground within 40 m of the eye; fewer and lower with the distance: grass, of which little
/// grows under closed crowns, herbs where crowns let some light through, and saplings in gaps and at edges.
/// Their positions do not depend on the eye.
osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                        const osg::Vec3d& eye);
