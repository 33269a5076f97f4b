// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Ground.h>

#include <osg/BoundingBox>
#include <osg/Geometry>

#include <glm/vec3.hpp>

#include <array>

namespace osgTreeWind {

/// What of a ground is drawn, and in which frame.
struct DrawnGround {
    GroundPtr ground;
    glm::dvec3 origin{0.0};         ///< Of the forest, in the world's frame.
    glm::dvec2 low{0.0}, high{0.0}; ///< Of the part that is drawn, in the world's frame.
};

/// Squares a mesh has each way.
constexpr int groundSquares = 64;

/// A square of a ground as triangles with normals, texture coordinates in metres and skirts where others are
/// beside it; cut off where the part that is drawn ends, without triangles over holes.
struct GroundMesh {
    /// @param corner the south-west one, in the world's frame. @param spacing of its vertices, metres.
    GroundMesh(const DrawnGround& drawn, const glm::dvec2& corner, double spacing);

    osg::ref_ptr<osg::Geometry> geometry; ///< In the forest's frame.
    /// What holds each quarter of it, whatever lies between the vertices: south-west, -east, north-west,
    /// -east. Not valid where there is nothing.
    std::array<osg::BoundingBox, 4> quarters;
};

} // namespace osgTreeWind
