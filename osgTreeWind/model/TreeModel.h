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
#include <vector>

namespace osgTreeWind {

/// The rest geometry of one tree shape, shared by all trees drawn with it.
struct TreeModel {
    Skeleton skeleton;                                       ///< Its wood in units.
    BranchSkin skin;                                         ///< Its bark.
    std::vector<LeafCluster> leaves;                         ///< Where leaves hang.
    std::array<LeafVertex, verticesPerLeafCluster> leafMesh; ///< One cluster of them, shared.
    std::vector<ShootWood> shootWood;                        ///< shootWoodOf() its skeleton.
    TreeExtents extents; ///< makeTreeExtents() of the above without `hanging`: measureTree(), fitTree().
    std::uint64_t identity = 0; ///< Number that only one sharedTreeModel() ever has; 0 in any other model.
};

/// Grows skeleton, skin and leaves. All seeds of `parameters` are offset by `variant`.
TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant = 0);
/// The same model for all in the process that hold it at a time. Any thread.
std::shared_ptr<const TreeModel> sharedTreeModel(const TreeParameters& parameters, std::uint32_t variant = 0);

/// What a tree is made of. Vertices are unique ones; triangles are what is drawn.
struct TreeCounts {
    std::uint64_t units = 0;          ///< Pieces of wood that turn.
    std::uint64_t branches = 0;       ///< Of one or more units.
    std::uint64_t skeletonPoints = 0; ///< Points of centre lines.
    std::uint64_t skinVertices = 0;   ///< Of bark.
    std::uint64_t skinTriangles = 0;  ///< Of bark.
    std::uint64_t leafVertices = 0;   ///< Of all clusters.
    std::uint64_t leafTriangles = 0;  ///< Of all clusters.

    std::uint64_t totalVertices() const { return skinVertices + leafVertices; }    ///< Of bark and leaves.
    std::uint64_t totalTriangles() const { return skinTriangles + leafTriangles; } ///< Of bark and leaves.
    TreeCounts& operator+=(const TreeCounts& other);                               ///< Adds each.
};

TreeCounts countTree(const TreeModel& model);
/// The same numbers without growing skin and leaves; all are exact.
TreeCounts countTree(const TreeParameters& parameters, std::uint32_t variant = 0);
/// Of each number the largest among variants 0 to `shapes` - 1. Of a tree that grows by light, which takes
/// its time, a quarter more than that of variant 0.
TreeCounts countLargest(const TreeParameters& parameters, int shapes);

} // namespace osgTreeWind
