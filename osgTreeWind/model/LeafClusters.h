// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// How leaves sit on a tree (thesis §2.4); ranges: TreeFields.h. The default makes 16 clusters of 3 quads on
/// every branch.
struct LeafParameters {
    int clustersPerBranch = 16; ///< 0 for a bare tree.
    int clusters = 0;  ///< Of the whole tree, spread evenly along its branches; 0: clustersPerBranch holds.
    float bare = 0.0f; ///< Of `clusters`: share of a branch at firstLevel without any, from its base; on
                       ///< further levels less, on the outermost 0.
    float thinWood = 1.0f; ///< Of `clusters`: share of the length of all wood, the thinnest, that bears some.
    int firstLevel = 1;    ///< Lowest branch level that bears leaves (the trunk is 0).
    float length = 0.5f;   ///< Cluster length along its petiole at the outermost level, metres.
    float width = 0.45f;   ///< Cluster width, metres.
    float innerSize = 0.5f; ///< Size at `firstLevel` over size at the outermost level.
    float droop = 0.3f;     ///< 0: clusters stand off the branch; 1: they hang down; -1: they point up.
    /// Of `clusters`: mean angle of leaf faces from the horizontal, radians; each cluster is a flat
    /// spray with its own. 0: clusters are fans, with faces to all sides.
    float inclination = 0.0f;
    /// Of `clusters`: each is a segment of a frond, which is the branch, with rows of leaflets on both sides
    /// and one that hangs. `length` is along the branch, `width` that of a row.
    bool frond = false;
    /// Of `clusters` with an inclination: each is drawn as a twig with two rows of shoots that hang, more
    /// than twice as long as wide, and one upon it. How wide a crown is does not follow from it.
    bool hanging = false;
    float area = 0.0f;      ///< Of all quads over the trunk's cross-section at breast height; 0: length
                            ///< and width hold as they are, else they tell the proportions.
    std::uint32_t seed = 1; ///< One seed gives the same leaves.
};

/// The parameters with every value brought into its range; NaN becomes the default.
LeafParameters clamped(LeafParameters parameters);

/// One cluster: what the thesis calls a leaf, with angles of its own (§2.4, §3.2).
struct LeafCluster {
    glm::vec3 anchor{0.0f}; ///< Where its petiole meets the branch, metres, tree frame at rest.
    int unit = 0;           ///< Branch unit it sits on.
    glm::quat orientation{1.0f, 0.0f, 0.0f,
                          0.0f}; ///< Leaf frame (petiole along +Z, face normal -Y) to tree frame.
    float size = 1.0f;           ///< Factor on the mesh of makeLeafMesh().
};

/// Clusters in access order, unit after unit. Parameters are clamped().
std::vector<LeafCluster> makeLeafClusters(const Skeleton& skeleton, const LeafParameters& parameters);

/// Whether a tree that bears a share of its leaves, [0, 1], has those of a cluster. As
/// shaders/instance_leaf.vert.
inline bool isBorne(std::size_t cluster, float share) {
    return glm::fract(0.618034f * static_cast<float>(cluster)) < share;
}

/// A corner of one of the three quads that make up a cluster, in the leaf frame.
struct LeafVertex {
    glm::vec3 corner{0.0f}; ///< Metres; the petiole starts at the origin.
    glm::vec3 normal{0.0f}; ///< Of its face, unit.
    glm::vec2 uv{0.0f};     ///< (0,0) to (1,1) over each quad, v along the petiole; of fronds across it.
};

constexpr int quadsPerLeafCluster = 3;
constexpr int verticesPerLeafCluster = quadsPerLeafCluster * 4;
constexpr int trianglesPerLeafCluster = quadsPerLeafCluster * 2;

/// The one mesh all clusters share (the thesis' display list, §2.4.1): quads 4i .. 4i+3. A fan about the
/// petiole, or with an inclination a flat spray, or shoots that hang.
std::array<LeafVertex, verticesPerLeafCluster> makeLeafMesh(const LeafParameters& parameters);

} // namespace osgTreeWind
