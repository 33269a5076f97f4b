// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Geometry>

namespace osgTreeWind {

/// Gives each array of a geometry a unique modified count. Works around osg::State, which identifies the last
/// array by address and count: a new array at the address of a deleted one would be drawn from a deleted
/// buffer. Call it after the arrays are filled. Any thread.
void makeArraysDistinct(osg::Geometry& geometry);

} // namespace osgTreeWind
