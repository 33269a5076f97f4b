// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Geometry>

namespace osgTreeWind {

/// Gives every array of a geometry a modified count that no other array here has. osg::State takes an array
/// for the one it set last when address and count agree; a new array often gets the address of a deleted one,
/// and OpenGL would then read from a buffer that is gone. Call it once the arrays are filled. Any thread.
void makeArraysDistinct(osg::Geometry& geometry);

} // namespace osgTreeWind
