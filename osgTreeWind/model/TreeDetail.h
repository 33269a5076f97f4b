// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/LeafClusters.h>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// How much of a tree is drawn.
struct TreeDetail {
    float bark = 0.0f; ///< By so much, over the height of the tree, it may be off: makeBranchSkin().
    float thinnest =
        0.0f; ///< Units and shoots thinner at their base, over the height of the tree, are left out.
    float leafShare = 1.0f; ///< Of the leaf clusters, [0, 1].
    int bough = 1;          ///< 2 to 4: each is one card of boughs that many times a spray's. 1: its sprays.
    float leafArea = 1.0f;  ///< Of the cards over that of the whole tree, > 0.

    static constexpr TreeDetail full() { return {}; }
    /// Less bark; then ever fewer and larger cards as well, whose leaves keep about their size. 0 times:
    /// full().
    static constexpr int reductions = 5;
    static TreeDetail reduced(int times);
};

/// Some leaf clusters in place of all.
struct ThinnedLeaves {
    std::vector<LeafCluster> clusters;
    std::vector<std::uint32_t> indices; ///< Of each among all: phases and colours follow it.
    int bough = 1;                      ///< As of TreeDetail.

    /// Of each, those of the mesh from this one on: one by turns, so that together they face as all do.
    int quads() const { return bough > 1 ? 1 : quadsPerLeafCluster; }
    int firstQuad(std::size_t i) const {
        return bough > 1 ? static_cast<int>(indices[i] % quadsPerLeafCluster) : 0;
    }
};

/// Some clusters, as even a sample of them all as of those on each unit, and the more of them the others
/// among them, enlarged about their outer halves so that all together have the area that `detail` says. Where
/// all are kept they stay as they are, to the bit.
ThinnedLeaves thinnedLeaves(const std::vector<LeafCluster>& leaves,
                            const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                            const TreeDetail& detail);

/// Middle of some quads of a cluster.
glm::vec3 middleOf(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int firstQuad, int quads);

/// As `detail` says.
BranchSkin thinnedSkin(const Skeleton& skeleton, const TreeDetail& detail);

} // namespace osgTreeWind
