// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>

#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Bark in vertex buffers, as shaders/branchwise/bark.vert and shaders/instance_bark.vert describe them.
/// @param crown of the tree, which shades it.
osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const Skeleton& skeleton,
                                             const CrownShade& crown);

/// Leaf clusters in vertex buffers, as shaders/branchwise/leaf.vert and shaders/instance_leaf.vert describe
/// them.
/// @param crown of the tree, which shades them.
osg::ref_ptr<osg::Geometry> makeLeafGeometry(const ThinnedLeaves& leaves, const Skeleton& skeleton,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown);
/// The same of all of them.
osg::ref_ptr<osg::Geometry> makeLeafGeometry(const std::vector<LeafCluster>& leaves, const Skeleton& skeleton,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown);

/// Triangles over `clusters` leaf clusters of that many four-cornered quads.
std::vector<unsigned> leafIndices(std::size_t clusters, int quads = quadsPerLeafCluster);
/// Triangles over such quads, in this order.
std::vector<unsigned> leafIndices(const std::vector<unsigned>& quads);

} // namespace osgTreeWind
