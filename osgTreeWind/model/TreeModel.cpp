// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeModel.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

const Skeleton& scanOf(const TreeParameters& parameters, std::uint32_t variant) {
    return (*parameters.scans)[variant % parameters.scans->size()].skeleton;
}

} // namespace

TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant) {
    TreeParameters p = parameters;
    p.wood.seed += variant;
    p.leaves.seed += variant;
    TreeModel model;
    model.skeleton = p.scans ? scanOf(p, variant) : makeRecursiveTree(p.wood);
    model.skin = makeBranchSkin(model.skeleton);
    model.leaves = makeLeafClusters(model.skeleton, p.leaves);
    model.leafMesh = makeLeafMesh(p.leaves);
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

TreeCounts countTree(const TreeParameters& parameters, std::uint32_t variant) {
    const LeafParameters leaves = clamped(parameters.leaves);
    TreeCounts counts;
    std::uint64_t leafyUnits = 0, rings = 0;
    if (parameters.scans) {
        const Skeleton& skeleton = scanOf(parameters, variant);
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
    const auto clusters = leafyUnits * static_cast<std::uint64_t>(leaves.clustersPerBranch);
    counts.skeletonPoints = counts.units * rings;
    counts.skinVertices = counts.skeletonPoints * BranchSkin::verticesPerRing;
    counts.skinTriangles = counts.units * (rings - 1) * BranchSkin::verticesPerRing * 2;
    counts.leafVertices = clusters * verticesPerLeafCluster;
    counts.leafTriangles = clusters * trianglesPerLeafCluster;
    return counts;
}

TreeCounts countLargest(const TreeParameters& parameters, int shapes) {
    TreeCounts largest = countTree(parameters);
    const int distinct = parameters.scans ? std::min(shapes, static_cast<int>(parameters.scans->size())) : 1;
    for (int shape = 1; shape < distinct; ++shape) {
        const TreeCounts counts = countTree(parameters, static_cast<std::uint32_t>(shape));
        for (const auto number : {&TreeCounts::units, &TreeCounts::branches, &TreeCounts::skeletonPoints,
                                  &TreeCounts::skinVertices, &TreeCounts::skinTriangles,
                                  &TreeCounts::leafVertices, &TreeCounts::leafTriangles})
            largest.*number = std::max(largest.*number, counts.*number);
    }
    return largest;
}

} // namespace osgTreeWind
