// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Ground.h>

#include <osg/BoundingBox>
#include <osg/Geometry>

#include <glm/vec3.hpp>

#include <array>

namespace osgTreeWind {

/// The part of a ground to draw.
struct DrawnGround {
    GroundPtr ground;
    glm::dvec3 origin{0.0};         ///< Of the forest, in the world's frame.
    glm::dvec2 low{0.0}, high{0.0}; ///< Corners of the part, in the world's frame.
};

/// Number of grid squares along each side of a mesh.
constexpr int groundSquares = 64;

/// A square of a ground as a triangle mesh with normals, texture coordinates in metres, and skirts on sides
/// with neighbours. It is clipped to the part to draw and has no triangles over holes.
struct GroundMesh {
    /// @param corner south-west corner, in the world's frame. @param spacing of the vertices, metres.
    GroundMesh(const DrawnGround& drawn, const glm::dvec2& corner, double spacing);

    osg::ref_ptr<osg::Geometry> geometry; ///< In the forest's frame.
    /// Conservative bounds of the quarters, with a margin for ground between the vertices: south-west,
    /// south-east, north-west, north-east. Invalid for a quarter without ground.
    std::array<osg::BoundingBox, 4> quarters;
};

} // namespace osgTreeWind
