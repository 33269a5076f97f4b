// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

constexpr int shadowStencil = 1;

/// What each tree of a forest keeps of the sun from the ground: a silhouette a shape at rest, as the sun
/// throws it, softer the farther it falls, which leans as far as its tree does. Leaves in the alpha of the
/// picture, which is to be 1 before, the share of the sun's light that comes through the darkest of them, and
/// `shadowStencil` in its stencil where any falls.
/// @param sun toward it, unit length, above the horizon. @param above a node that is updated after the
/// forest.
osg::ref_ptr<osg::Geometry> createGroundShadows(const osgTreeWind::Forest& forest, const osg::Vec3& sun,
                                                osg::Node& above);
