// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/model/BranchSkin.h>
#include <osgTreeWind/model/GrownTree.h>
#include <osgTreeWind/model/LeafClusters.h>
#include <osgTreeWind/model/RecursiveTree.h>
#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeExtents.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// Everything that shapes a tree.
struct TreeParameters {
    RecursiveTreeParameters wood;
    std::optional<GrownTreeParameters> grown; ///< In place of `wood`.
    /// In place of both: variant v takes scan v modulo their number. Null or at least one.
    std::shared_ptr<const std::vector<ScannedTree>> scans;
    LeafParameters leaves;
};

/// The rest geometry of one tree shape, shared by all trees drawn with it.
struct TreeModel {
    Skeleton skeleton;
    BranchSkin skin;
    std::vector<LeafCluster> leaves;
    std::array<LeafVertex, verticesPerLeafCluster> leafMesh;
    TreeExtents extents; ///< makeTreeExtents() of the above without `hanging`: measureTree(), fitTree().
};

/// Grows skeleton, skin and leaves. All seeds of `parameters` are offset by `variant`.
OSGTREEWIND_EXPORT TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant = 0);

/// What a tree is made of. Vertices are unique ones; triangles are what is drawn.
struct OSGTREEWIND_EXPORT TreeCounts {
    std::uint64_t units = 0, branches = 0, skeletonPoints = 0;
    std::uint64_t skinVertices = 0, skinTriangles = 0;
    std::uint64_t leafVertices = 0, leafTriangles = 0;

    std::uint64_t totalVertices() const { return skinVertices + leafVertices; }
    std::uint64_t totalTriangles() const { return skinTriangles + leafTriangles; }
    TreeCounts& operator+=(const TreeCounts& other);
};

OSGTREEWIND_EXPORT TreeCounts countTree(const TreeModel& model);
/// The same numbers without growing skin and leaves; all are exact.
OSGTREEWIND_EXPORT TreeCounts countTree(const TreeParameters& parameters, std::uint32_t variant = 0);
/// Of each number the largest among variants 0 to `shapes` - 1.
TreeCounts countLargest(const TreeParameters& parameters, int shapes);

} // namespace osgTreeWind
