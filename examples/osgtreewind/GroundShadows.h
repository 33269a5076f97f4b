// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

/// What each tree of a forest at rest keeps of the sun from level ground: a silhouette a shape, as the sun
/// throws it, softer the farther it falls. Darkens what is drawn before it.
/// @param sun toward it, unit length, above the horizon.
osg::ref_ptr<osg::Geometry> createGroundShadows(const osgTreeWind::Forest& forest, const osg::Vec3& sun);
