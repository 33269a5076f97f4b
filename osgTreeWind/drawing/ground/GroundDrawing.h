// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Ground.h>

#include <osg/Node>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// A ground about a forest, up to 50 km beyond it, in the forest's frame: triangles with normals and texture
/// coordinates in metres, finer where a camera is near. Null where there is none of it.
/// @param origin of the forest. @param centre of its trees, in the world's frame as well. @param radius of
/// what holds them, metres.
osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr& ground, const glm::dvec3& origin,
                                            const glm::dvec2& centre, double radius);

} // namespace osgTreeWind
