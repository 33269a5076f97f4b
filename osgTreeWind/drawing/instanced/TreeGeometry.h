// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>
#include <osg/StateSet>

#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Makes the bark geometry with the vertex arrays of shaders/branchwise/bark.vert and
/// shaders/bark_vertex.glsl.
/// @param crown shade of the tree's own crown.
osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const Skeleton& skeleton,
                                             const CrownShade& crown);

/// Packs the bark of several skins of a tree, one after another, into 24 bytes per vertex for
/// shaders/bark_vertex.glsl, without triangles. In a tree of 30 m, vertices move by at most 0.6 mm.
/// @param state gets the uniforms that unpack it.
osg::ref_ptr<osg::Geometry> makePackedBark(const std::vector<BranchSkin>& skins, const Skeleton& skeleton,
                                           const CrownShade& crown, osg::StateSet& state);

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

/// Triangle indices of `clusters` whole leaf clusters.
std::vector<unsigned> leafIndices(std::size_t clusters);

} // namespace osgTreeWind
