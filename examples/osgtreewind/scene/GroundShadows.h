// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Geometry>

constexpr int shadowStencil = 1;

/// Soft shadows of trees on the ground: one silhouette per shape, as the sun casts it from the tree at rest.
/// It leans with its tree and becomes softer with the distance. The shadows write the share of sunlight under
/// the darkest of them to the alpha of the picture, which must be 1 before, and `shadowStencil` to its
/// stencil.
/// @param sun unit vector to the sun, above the horizon. @param above node that is updated after the forest.
osg::ref_ptr<osg::Geometry> createGroundShadows(const osgTreeWind::Forest& forest, const osg::Vec3& sun,
                                                osg::Node& above);
