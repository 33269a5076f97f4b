// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <osg/Geometry>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A part of a tree's bark or leaves that is culled on its own: a range of indices of one geometry.
struct MeshPart {
    std::uint32_t firstIndex = 0, indices = 0;
    std::int32_t firstVertex = 0;             ///< Added to the indices.
    glm::vec3 centre{0.0f}, halfExtent{0.0f}; ///< Bounding box at rest, metres, the tree's frame.
    float reach = 0.0f; ///< From a branch to the surface of its bark, or a leaf's end, m.
    float rise = 0.0f;  ///< Sway of the centre over that of the treetop.
    float area = 0.0f;  ///< Mean projected area of what it draws, m².
};

/// Items in an order in which neighbours lie close together, in groups.
struct NearGroups {
    std::vector<std::uint32_t> order; ///< Indices of the items, group after group; ascending within each.
    std::vector<std::uint32_t> ends;  ///< Ends of the groups in `order`.
};
/// Halves the items at the median along the longest side of their bounding box until no group has more than
/// `most`. The same places give the same groups everywhere.
NearGroups groupNear(const std::vector<glm::vec3>& places, std::size_t most);

/// Sorts leaf clusters into parts of up to 32 cards; their vertices follow each other in the result.
/// @param coverage share of a card that leaves cover (LeafCoverage.h).
std::vector<MeshPart> sortIntoParts(ThinnedLeaves& leaves,
                                    const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                    float coverage, float treeHeight);
/// Sorts the triangles of a skin into parts of up to 192 triangles. Parts share vertices.
std::vector<MeshPart> sortIntoParts(BranchSkin& skin, float treeHeight);

} // namespace osgTreeWind
