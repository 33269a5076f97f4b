// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeModel.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

Skeleton makeSkeleton(const TreeParameters& parameters) {
    return parameters.grown ? makeGrownTree(*parameters.grown) : makeRecursiveTree(parameters.wood);
}

/// Cross-section of the trunk at breast height (a tenth of a tree below 13 m), m^2.
float trunkSection(const Skeleton& skeleton) {
    float height = 0.0f, radius = 0.0f;
    for (const BranchUnit& unit : skeleton.units)
        height = std::max(height, unit.tip.z);
    const float breast = std::min(1.3f, 0.1f * height);
    for (const BranchUnit& unit : skeleton.units)
        if (unit.parent < 0 || (unit.level == 0 && breast >= unit.base.z))
            radius = glm::mix(unit.baseRadius, unit.tipRadius,
                              std::clamp((breast - unit.base.z) / std::max(unit.tip.z - unit.base.z, 1e-6f), 0.0f, 1.0f));
    return glm::pi<float>() * radius * radius;
}

/// Makes the quads of all clusters `area` large together, m^2.
void setArea(TreeModel& model, float area) {
    float now = 0.0f;
    for (const LeafCluster& leaf : model.leaves)
        now += leaf.size * leaf.size;
    const std::array<LeafVertex, verticesPerLeafCluster>& mesh = model.leafMesh;
    now *= quadsPerLeafCluster * glm::distance(mesh[0].corner, mesh[1].corner) *
           glm::distance(mesh[1].corner, mesh[2].corner);
    if (now > 0.0f)
        for (LeafVertex& vertex : model.leafMesh)
            vertex.corner *= std::sqrt(area / now);
}

} // namespace

TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant) {
    TreeParameters p = parameters;
    p.wood.seed += variant;
    p.leaves.seed += variant;
    if (p.grown)
        p.grown->seed += variant;
    TreeModel model;
    model.skeleton = makeSkeleton(p);
    model.skin = makeBranchSkin(model.skeleton);
    model.leaves = makeLeafClusters(model.skeleton, p.leaves);
    model.leafMesh = makeLeafMesh(p.leaves);
    if (const float area = clamped(p.leaves).area; area > 0.0f)
        setArea(model, area * trunkSection(model.skeleton));
    model.extents = makeTreeExtents(model);
    return model;
}

TreeCounts& TreeCounts::operator+=(const TreeCounts& other) {
    units += other.units;
    branches += other.branches;
    skeletonPoints += other.skeletonPoints;
    skinVertices += other.skinVertices;
    skinTriangles += other.skinTriangles;
    leafVertices += other.leafVertices;
    leafTriangles += other.leafTriangles;
    return *this;
}

TreeCounts countTree(const TreeModel& model) {
    TreeCounts counts;
    counts.units = model.skeleton.units.size();
    for (const BranchUnit& unit : model.skeleton.units)
        counts.branches += unit.level > 0;
    counts.skeletonPoints = model.skeleton.points.size();
    counts.skinVertices = model.skin.vertices.size();
    counts.skinTriangles = model.skin.indices.size() / 3;
    counts.leafVertices = model.leaves.size() * verticesPerLeafCluster;
    counts.leafTriangles = model.leaves.size() * trianglesPerLeafCluster;
    return counts;
}

TreeCounts countTree(const TreeParameters& parameters) {
    const LeafParameters leaves = clamped(parameters.leaves);
    TreeCounts counts;
    std::uint64_t leafyUnits = 0, rings = 0;
    if (parameters.grown) {
        const Skeleton skeleton = makeGrownTree(*parameters.grown);
        rings = static_cast<std::uint64_t>(skeleton.ringsPerBranch);
        counts.units = skeleton.units.size();
        for (const BranchUnit& unit : skeleton.units) {
            counts.branches += unit.level > 0;
            leafyUnits += unit.level >= leaves.firstLevel;
        }
    } else {
        const RecursiveTreeParameters p = clamped(parameters.wood);
        rings = static_cast<std::uint64_t>(p.ringsPerBranch);
        counts.units = static_cast<std::uint64_t>(p.trunkUnits);
        leafyUnits = leaves.firstLevel == 0 ? counts.units : 0;
        auto onLevel = static_cast<std::uint64_t>(branchingUnits(p));
        for (int level = 1; level <= p.levels; ++level) {
            onLevel *= static_cast<std::uint64_t>(p.childrenPerBranch);
            counts.branches += onLevel;
            if (level >= leaves.firstLevel)
                leafyUnits += onLevel;
        }
        counts.units += counts.branches;
    }
    const auto ofTree = static_cast<std::uint64_t>(leaves.clusters);
    const auto ofBranch = static_cast<std::uint64_t>(leaves.clustersPerBranch);
    const std::uint64_t clusters = ofTree > 0 ? (leafyUnits > 0 ? ofTree : 0) : leafyUnits * ofBranch;
    counts.skeletonPoints = counts.units * rings;
    counts.skinVertices = counts.skeletonPoints * BranchSkin::verticesPerRing;
    counts.skinTriangles = counts.units * (rings - 1) * BranchSkin::verticesPerRing * 2;
    counts.leafVertices = clusters * verticesPerLeafCluster;
    counts.leafTriangles = clusters * trianglesPerLeafCluster;
    return counts;
}

} // namespace osgTreeWind
