// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeModel.h>

#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/growth/FormCache.h>
#include <osgTreeWind/model/FormSkeleton.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/PalmTree.h>
#include <osgTreeWind/model/RecursiveTree.h>
#include <osgTreeWind/model/SideShoots.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/model/TreeSize.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

namespace osgTreeWind {
namespace {

Skeleton makeSkeleton(const TreeParameters& parameters, std::uint32_t variant) {
    if (parameters.scans)
        return (*parameters.scans)[variant % parameters.scans->size()].skeleton;
    if (parameters.growth) {
        GrowthParameters growth = *parameters.growth;
        growth.seed += variant;
        Skeleton skeleton = makeSkeleton(*grownForm(growth));
        skeleton.flare = growth.flare;
        return skeleton;
    }
    if (parameters.palm) {
        PalmParameters palm = *parameters.palm;
        palm.seed += variant;
        return makePalmTree(palm);
    }
    RecursiveTreeParameters wood = parameters.wood;
    wood.seed += variant;
    return makeRecursiveTree(wood);
}

/// @return whether there are any.
bool addSideShoots(Skeleton& skeleton, const TreeParameters& parameters, const LeafParameters& leaves) {
    if (!parameters.growth || !(leaves.sideShoots > 0.0f))
        return false;
    addSideShoots(skeleton, leaves.sideShoots, leaves.seed);
    return true;
}

/// Scales the mesh, so that the quads of all clusters have a total area of `area`, m^2.
void scaleToArea(TreeModel& model, float area) {
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

SharedConstants<std::string, TreeModel>& sharedModels() {
    static SharedConstants<std::string, TreeModel> models;
    return models;
}

template <typename T>
void addBytes(const std::vector<T>& values, std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// A key that identifies a shape.
std::string shapeKey(const TreeParameters& parameters, std::uint32_t variant) {
    std::string key = std::to_string(variant) + ' ';
    addKeyBytes(parameters.leaves, key);
    if (parameters.scans) {
        const Skeleton& scan = (*parameters.scans)[variant % parameters.scans->size()].skeleton;
        key += scan.joined ? "joined scan " : "scan ";
        key += std::to_string(scan.ringsPerBranch) + ' ' + std::to_string(scan.units.size()) + ' ';
        addBytes(std::vector<float>{scan.flare}, key);
        addBytes(scan.units, key);
        addBytes(scan.points, key);
        for (const Shoot& shoot : scan.shoots) { // has padding and an index that does not matter
            key += std::to_string(shoot.unit) + ' ' + std::to_string(shoot.count) + ' ';
            addBytes(std::vector<float>{shoot.baseRadius, shoot.tipRadius, shoot.leafy.from, shoot.leafy.to},
                     key);
        }
        addBytes(scan.shootPoints, key);
        addBytes(scan.leafyUnits, key);
    } else if (parameters.growth) {
        key += "growth" + formKey(*parameters.growth);
        addBytes(std::vector<float>{parameters.growth->flare}, key);
    } else if (parameters.palm) {
        key += "palm";
        addKeyBytes(*parameters.palm, key);
    } else {
        key += "wood";
        addKeyBytes(parameters.wood, key);
    }
    return key;
}

} // namespace

const BranchSkin& SkinOnDemand::of(const Skeleton& skeleton) const {
    std::call_once(_skin->once, [&] { _skin->skin = makeBranchSkin(skeleton); });
    return _skin->skin;
}

TreeModel makeTreeModel(const TreeParameters& parameters, std::uint32_t variant) {
    LeafParameters leaves = clamped(parameters.leaves);
    leaves.seed += variant;
    TreeModel model;
    model.skeleton = makeSkeleton(parameters, variant);
    model.shootWood = shootWoodOf(model.skeleton);
    model.leaves = makeLeafClusters(model.skeleton, leaves);
    const auto setMesh = [&] {
        model.leafMesh = makeLeafMesh(leaves);
        if (leaves.area > 0.0f)
            scaleToArea(model, leaves.area * trunkSection(model.skeleton));
    };
    const bool hanging = std::exchange(leaves.hanging, false);
    setMesh();
    model.extents = makeTreeExtents(model);
    if (hanging) {
        leaves.hanging = true;
        setMesh();
    }
    if (addSideShoots(model.skeleton, parameters, leaves))
        model.leaves = makeLeafClusters(model.skeleton, leaves);
    return model;
}

std::shared_ptr<const TreeModel> sharedTreeModel(const TreeParameters& parameters, std::uint32_t variant) {
    return sharedModels().get(shapeKey(parameters, variant), [&] {
        static std::atomic<std::uint64_t> last{0};
        auto model = std::make_shared<TreeModel>(makeTreeModel(parameters, variant));
        model->identity = ++last;
        return model;
    });
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
    const SkinSize skin = sizeOfBranchSkin(model.skeleton);
    counts.skinVertices = skin.vertices;
    counts.skinTriangles = skin.triangles;
    counts.leafVertices = model.leaves.size() * verticesPerLeafCluster;
    counts.leafTriangles = model.leaves.size() * trianglesPerLeafCluster;
    return counts;
}

TreeCounts countTree(const TreeParameters& parameters, std::uint32_t variant) {
    if (const auto known = sharedModels().find(shapeKey(parameters, variant)))
        return countTree(*known);
    LeafParameters leaves = clamped(parameters.leaves);
    leaves.seed += variant;
    TreeCounts counts;
    std::uint64_t clusters = 0;
    SkinSize skin;
    if (parameters.scans || parameters.growth || parameters.palm) {
        Skeleton skeleton = makeSkeleton(parameters, variant);
        addSideShoots(skeleton, parameters, leaves);
        counts.units = skeleton.units.size();
        counts.skeletonPoints = skeleton.points.size();
        skin = sizeOfBranchSkin(skeleton);
        for (const BranchUnit& unit : skeleton.units)
            counts.branches += unit.level > 0;
        clusters = makeLeafClusters(skeleton, leaves).size();
    } else {
        const RecursiveTreeParameters p = clamped(parameters.wood);
        const auto rings = static_cast<std::uint64_t>(p.ringsPerBranch);
        counts.units = static_cast<std::uint64_t>(p.trunkUnits);
        std::uint64_t leafyUnits = leaves.firstLevel == 0 ? counts.units : 0;
        auto onLevel = static_cast<std::uint64_t>(branchingUnits(p));
        for (int level = 1; level <= p.levels; ++level) {
            onLevel *= static_cast<std::uint64_t>(p.childrenPerBranch);
            counts.branches += onLevel;
            if (level >= leaves.firstLevel)
                leafyUnits += onLevel;
        }
        counts.units += counts.branches;
        const auto ofTree = static_cast<std::uint64_t>(leaves.clusters);
        const auto ofBranch = static_cast<std::uint64_t>(leaves.clustersPerBranch);
        clusters = ofTree > 0 ? (leafyUnits > 0 ? ofTree : 0) : leafyUnits * ofBranch;
        counts.skeletonPoints = counts.units * rings;
        skin.vertices = counts.skeletonPoints * BranchSkin::verticesPerRing;
        skin.triangles = counts.units * (rings - 1) * BranchSkin::verticesPerRing * 2;
    }
    counts.skinVertices = skin.vertices;
    counts.skinTriangles = skin.triangles;
    counts.leafVertices = clusters * verticesPerLeafCluster;
    counts.leafTriangles = clusters * trianglesPerLeafCluster;
    return counts;
}

TreeCounts countLargest(const TreeParameters& parameters, int shapes) {
    TreeCounts largest = countTree(parameters);
    constexpr std::array numbers{&TreeCounts::units,          &TreeCounts::branches,
                                 &TreeCounts::skeletonPoints, &TreeCounts::skinVertices,
                                 &TreeCounts::skinTriangles,  &TreeCounts::leafVertices,
                                 &TreeCounts::leafTriangles};
    if (parameters.growth && !parameters.scans) {
        for (const auto number : numbers)
            largest.*number += largest.*number / 4;
        return largest;
    }
    const int variants = parameters.scans  ? std::min(shapes, static_cast<int>(parameters.scans->size()))
                         : parameters.palm ? shapes
                                           : 1;
    for (int shape = 1; shape < variants; ++shape) {
        const TreeCounts counts = countTree(parameters, static_cast<std::uint32_t>(shape));
        for (const auto number : numbers)
            largest.*number = std::max(largest.*number, counts.*number);
    }
    return largest;
}

} // namespace osgTreeWind
