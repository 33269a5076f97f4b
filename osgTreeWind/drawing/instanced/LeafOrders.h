// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>

#include <glm/vec3.hpp>

#include <array>

namespace osgTreeWind {

/// Front-to-back draw orders of the leaf cards of a tree, one for each of ten view directions. Near cards
/// come first, so that the depth test rejects most of the cards behind them.
struct LeafOrders {
    static constexpr std::size_t count = 10;
    using Geometries = std::array<osg::ref_ptr<osg::Geometry>, count>;

    /// Unit directions toward the eye in the tree's frame: up, down and eight around the horizon.
    static const std::array<glm::vec3, count>& directions();
    /// Index of the nearest of the directions. @param toEye in the tree's frame, of any length.
    static std::size_t nearest(const glm::vec3& toEye);

    /// @return a geometry for each order. They share the vertices of `geometry`.
    /// @param geometry result of makeLeafGeometry() for `leaves` and `mesh`.
    static Geometries make(const osg::Geometry& geometry, const ThinnedLeaves& leaves,
                           const std::array<LeafVertex, verticesPerLeafCluster>& mesh);
};

} // namespace osgTreeWind
