// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>

#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Makes the bark geometry with the vertex arrays of shaders/branchwise/bark.vert and
/// shaders/instance_bark.vert.
/// @param crown shade of the tree's own crown.
osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const Skeleton& skeleton,
                                             const CrownShade& crown);

/// Makes the leaf geometry of all clusters with the vertex arrays of shaders/branchwise/leaf.vert and
/// shaders/leaf_corner.glsl.
/// @param crown shade of the tree's own crown.
osg::ref_ptr<osg::Geometry> makeLeafGeometry(const std::vector<LeafCluster>& leaves, const Skeleton& skeleton,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown);

/// Appends the records of leaf clusters for shaders/leaf_corner.glsl, leafRecordTexels texels each.
void addLeafRecords(const ThinnedLeaves& leaves, const Skeleton& skeleton,
                    const std::array<LeafVertex, verticesPerLeafCluster>& mesh, const CrownShade& crown,
                    std::vector<glm::vec4>& records);
constexpr int leafRecordTexels = 4;

/// Appends the vertices of a geometry with the same arrays. @return index of the first of them.
int appendVertices(osg::Geometry& whole, const osg::Geometry& more);

/// Triangle indices of `clusters` whole leaf clusters.
std::vector<unsigned> leafIndices(std::size_t clusters);

} // namespace osgTreeWind
