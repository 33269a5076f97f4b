// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/LeafClusters.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// How much of a tree is drawn. Numbers of vertices are those of the reference tree.
struct TreeDetail {
    SkinDetail skin;
    float leafShare = 1.0f;          ///< Of the leaf clusters, [0, 1].
    int quads = quadsPerLeafCluster; ///< Of each, the first ones, 1 to 3.
    float leafArea = 1.0f;           ///< Over that of the whole tree: large leaves hide each other less, > 0.

    static constexpr TreeDetail full() { return {}; }                                ///< 38,656
    static constexpr TreeDetail reducedOnce() { return {{5, 4}, 0.23f, 3, 0.76f}; }  ///< about a fifth
    static constexpr TreeDetail reducedTwice() { return {{2, 3}, 0.16f, 1, 0.58f}; } ///< about a twentieth
};

/// Some leaf clusters in place of all.
struct ThinnedLeaves {
    std::vector<LeafCluster> clusters;
    std::vector<std::uint32_t> indices; ///< Of each among all: phases and colours follow it.
    int quads = quadsPerLeafCluster;    ///< Of each, the first ones of the mesh.
    /// Added to the mipmap level of the leaf texture: from far away a texture is the more solid the smaller
    /// it is drawn, and enlarged clusters would let more sky through than those they stand for.
    float textureBias = 0.0f;
};

/// Every so manieth cluster, about as many on each unit, enlarged about its middle so that all together have
/// the area that `detail` says. Where all are kept they stay as they are, to the bit.
ThinnedLeaves thinnedLeaves(const std::vector<LeafCluster>& leaves,
                            const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                            const TreeDetail& detail);

} // namespace osgTreeWind
