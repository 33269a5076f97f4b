// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/LeafClusters.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeExtents.h>
#include <osgTreeWind/model/TreeParameters.h>
#include <osgTreeWind/model/WoodVolume.h>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace osgTreeWind {

/// The bark of a skeleton, made when it is first needed. Copies share it.
class SkinOnDemand {
public:
    /// Any thread. @param skeleton the same in all calls.
    const BranchSkin& of(const Skeleton& skeleton) const;

private:
    struct Skin {
        std::once_flag once;
        BranchSkin skin;
    };
    std::shared_ptr<Skin> _skin = std::make_shared<Skin>();
};

/// The rest geometry of one tree shape, shared by all trees drawn with it.
struct TreeModel {
    Skeleton skeleton; ///< Wood.
    /// Bark, kept from the first call on. Any thread.
    const BranchSkin& skin() const { return skinOnDemand.of(skeleton); }
    std::vector<LeafCluster> leaves;
    std::array<LeafVertex, verticesPerLeafCluster> leafMesh; ///< Shared by all clusters.
    std::vector<ShootWood> shootWood;                        ///< shootWoodOf(skeleton), without side shoots.
    TreeExtents
        extents; ///< makeTreeExtents() without `hanging` and side shoots; for measureTree(), fitTree().
    std::uint64_t identity = 0; ///< Unique for a sharedTreeModel(); 0 otherwise.
    SkinOnDemand skinOnDemand;
};

/// Grows skeleton and leaves. All seeds of `parameters` are offset by `variant`.
TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant = 0);
/// A model shared by all users in the process, as long as one of them holds it. Thread-safe.
std::shared_ptr<const TreeModel> sharedTreeModel(const TreeParameters& parameters, std::uint32_t variant = 0);

/// Sizes of a tree. Vertices are unique ones; triangles are those drawn.
struct TreeCounts {
    std::uint64_t units = 0;
    std::uint64_t branches = 0; ///< Units above the trunk.
    std::uint64_t skeletonPoints = 0;
    std::uint64_t skinVertices = 0;
    std::uint64_t skinTriangles = 0;
    std::uint64_t leafVertices = 0;  ///< Of all clusters.
    std::uint64_t leafTriangles = 0; ///< Of all clusters.

    std::uint64_t totalVertices() const { return skinVertices + leafVertices; }
    std::uint64_t totalTriangles() const { return skinTriangles + leafTriangles; }
    TreeCounts& operator+=(const TreeCounts& other);
};

TreeCounts countTree(const TreeModel& model);
/// The same exact numbers, without growing skin and leaves.
TreeCounts countTree(const TreeParameters& parameters, std::uint32_t variant = 0);
/// The maximum of each number over variants 0 to `shapes` - 1. For a tree grown by light, which takes long,
/// an estimate: variant 0 plus a quarter.
TreeCounts countLargest(const TreeParameters& parameters, int shapes);

} // namespace osgTreeWind
