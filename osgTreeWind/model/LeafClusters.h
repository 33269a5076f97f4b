// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeParameters.h>

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <vector>

namespace osgTreeWind {

/// Clamps every value to its range; NaN becomes the default.
LeafParameters clamped(LeafParameters parameters);

/// A leaf cluster; the thesis' leaf, with its own angles (§2.4, §3.2).
struct LeafCluster {
    glm::vec3 anchor{0.0f}; ///< Where its petiole meets the branch, metres, tree frame at rest.
    int unit = 0;           ///< Branch unit it sits on.
    /// From leaf frame (petiole along +Z, face normal -Y) to tree frame.
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
    float size = 1.0f; ///< Factor on the mesh of makeLeafMesh().
};

/// Makes the clusters of a tree in access order, unit after unit. Parameters are clamped().
std::vector<LeafCluster> makeLeafClusters(const Skeleton& skeleton, const LeafParameters& parameters);

/// Whether a tree with a share of its leaves, [0, 1], bears this cluster; the same rule as in
/// shaders/instance_leaf.vert.
inline bool isClusterBorne(std::size_t cluster, float share) {
    return glm::fract(0.618034f * static_cast<float>(cluster)) < share;
}

/// A corner of one of the three quads of a cluster, in the leaf frame.
struct LeafVertex {
    glm::vec3 corner{0.0f}; ///< Metres; the petiole starts at the origin.
    glm::vec3 normal{0.0f}; ///< Unit normal of its quad.
    glm::vec2 uv{0.0f};     ///< (0,0) to (1,1) over each quad; v along the petiole, or across a frond.
};

constexpr int quadsPerLeafCluster = 3;
constexpr int verticesPerLeafCluster = quadsPerLeafCluster * 4;
constexpr int trianglesPerLeafCluster = quadsPerLeafCluster * 2;

/// The mesh shared by all clusters (the thesis' display list, §2.4.1); quad i has vertices 4i to 4i+3. A fan
/// about the petiole or, with an inclination, a flat spray or hanging shoots.
std::array<LeafVertex, verticesPerLeafCluster> makeLeafMesh(const LeafParameters& parameters);

} // namespace osgTreeWind
