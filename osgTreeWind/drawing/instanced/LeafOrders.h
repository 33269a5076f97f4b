// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>

#include <glm/vec3.hpp>

#include <array>

namespace osgTreeWind {

/// Orders in which the leaf cards of a tree may be drawn, one for each of some directions it is seen from:
/// near ones first, so that they hide most of what comes after them.
struct LeafOrders {
    static constexpr std::size_t count = 10;
    using Geometries = std::array<osg::ref_ptr<osg::Geometry>, count>;

    /// Toward the eye, in the tree's frame, unit length: up, down, and all around.
    static const std::array<glm::vec3, count>& directions();
    /// The order for a direction. @param toEye in the tree's frame, of any length.
    static std::size_t nearest(const glm::vec3& toEye);

    /// The cards of one geometry in all orders, with the same vertices.
    /// @param geometry makeLeafGeometry() of `leaves` and `mesh`.
    static Geometries make(const osg::Geometry& geometry, const ThinnedLeaves& leaves,
                           const std::array<LeafVertex, verticesPerLeafCluster>& mesh);
};

} // namespace osgTreeWind
