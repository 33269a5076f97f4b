// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/LeafClusters.h>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Level of detail of a drawn tree.
struct TreeDetail {
    float bark = 0.0f;      ///< Tolerance of makeBranchSkin() over the height of the tree.
    float thinnest = 0.0f;  ///< Smallest base diameter of units and shoots over the height of the tree.
    float leafShare = 1.0f; ///< Share of the leaf clusters, [0, 1].
    int bough = 1;          ///< 1: clusters of sprays. 2 to 4: cards of boughs, that many times larger.
    float leafArea = 1.0f;  ///< Area of the cards over that of the full tree, > 0.

    static constexpr TreeDetail full() { return {}; }
    /// Detail reduced 0 (full()) to `reductions` times: first less bark, then also fewer and larger cards,
    /// whose leaves keep about their size.
    static constexpr int reductions = 5;
    static TreeDetail reduced(int times);
};

/// A sample of a tree's leaf clusters.
struct ThinnedLeaves {
    std::vector<LeafCluster> clusters;
    std::vector<std::uint32_t> indices; ///< Index in the full tree; determines phase and colour.
    int bough = 1;                      ///< As in TreeDetail.

    /// Quads drawn per cluster, from firstQuad() on. A bough uses one quad, in rotation, which keeps the
    /// overall distribution of directions.
    int quads() const { return bough > 1 ? 1 : quadsPerLeafCluster; }
    int firstQuad(std::size_t i) const {
        return bough > 1 ? static_cast<int>(indices[i] % quadsPerLeafCluster) : 0;
    }
    /// Centre of the drawn quads of a cluster, metres, tree frame at rest.
    glm::vec3 middle(std::size_t i, const std::array<LeafVertex, verticesPerLeafCluster>& mesh) const;
};

/// Selects clusters, evenly over the tree and over each unit; a larger share includes the clusters of a
/// smaller one. They are enlarged about their outer halves to the total area of `detail`. If all are
/// kept, they are unchanged, to the bit.
ThinnedLeaves thinnedLeaves(const std::vector<LeafCluster>& leaves,
                            const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                            const TreeDetail& detail);

/// Centre of some quads of a cluster.
glm::vec3 middleOf(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int firstQuad, int quads);
/// Their area, m².
float areaOf(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int firstQuad, int quads);

/// The skin of a skeleton at a level of detail.
BranchSkin thinnedSkin(const Skeleton& skeleton, const TreeDetail& detail);

} // namespace osgTreeWind
