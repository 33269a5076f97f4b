// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/MemoryEstimate.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

/// Arrays of a simulation, per branch unit and per leaf cluster.
constexpr std::uint64_t unitBytes = sizeof(WindPlace) + sizeof(glm::vec3) + 2 * sizeof(glm::vec4) +
                                    sizeof(glm::quat) + sizeof(UnitPose) + sizeof(Laws::ThesisBranch);
constexpr std::uint64_t leafBytes = sizeof(glm::vec4);

// Nodes, measured: a tree with its uniforms and drawables, and the texels of its units and leaves, which the
// graphics driver may hold a second time. Under `modal`, a tree in its cell and pose inputs for two frames.
constexpr std::uint64_t instanceBytes = 1000, posesInTexture = 4096,
                        unitPoseBytes = 2 * 4 * sizeof(glm::vec4), impostorBytes = 2000000;
constexpr std::uint64_t skinVertexBytes = 48, packedBarkBytes = 24, leafVertexBytes = 92,
                        leafRecordBytes = 64;
constexpr std::uint64_t treeNodeBytes = 8000, unitTexelBytes = 2 * 32, leafTexelBytes = 2 * 16;

std::uint64_t shapeBytes(const TreeCounts& counts) {
    return counts.units * sizeof(BranchUnit) + counts.skeletonPoints * sizeof(glm::vec3) +
           counts.leafVertices / verticesPerLeafCluster * sizeof(LeafCluster);
}

/// Of TreeModel::skin(), which nodes need: for geometry under a branchwise law, for picking under `modal`.
std::uint64_t skinBytes(const TreeCounts& counts) {
    return counts.skinVertices * sizeof(SkinVertex) + 3 * counts.skinTriangles * sizeof(std::uint32_t);
}

std::string problemOfTrees(const ForestDescription& description, std::uint64_t bytes) {
    return problemOfMemory(std::to_string(description.trees.size()) + " trees of these species", bytes);
}

} // namespace

MemoryEstimate estimateMemory(const ForestDescription& description) {
    const ShapeFamilies families(description);
    return estimateMemory(description, families, families.countLargest());
}

MemoryEstimate estimateMemory(const ForestDescription& description, const ShapeFamilies& families,
                              const std::vector<TreeCounts>& largest) {
    std::vector<std::uint64_t> trees(families.all().size(), 0);
    for (const TreePlacement& tree : description.trees)
        ++trees[families.indexOf(tree)];
    const bool modal = description.law == MotionLaw::Modal;
    MemoryEstimate memory;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const auto shapes = std::uint64_t(families.all()[i].shapes);
        const TreeCounts& counts = largest[i];
        const std::uint64_t leaves = counts.leafVertices / verticesPerLeafCluster;
        memory.simulation +=
            shapes * shapeBytes(counts) +
            trees[i] * (modal ? simulatedTreeBytes(ModalLevel::Near)
                              : sizeof(PlacedTree) + counts.units * unitBytes + leaves * leafBytes);
        memory.nodes += shapes * skinBytes(counts);
        if (modal)
            memory.nodes += trees[i] * instanceBytes +
                            shapes * (2 * meshBytes(counts) + impostorBytes + // with the copy of OpenGL
                                      std::min(trees[i], posesInTexture) * counts.units * unitPoseBytes);
        else
            memory.nodes +=
                shapes * geometryBytes(counts) +
                trees[i] * (treeNodeBytes + counts.units * unitTexelBytes + leaves * leafTexelBytes);
    }
    return memory;
}

std::uint64_t geometryBytes(const TreeCounts& counts) {
    return counts.skinVertices * skinVertexBytes + counts.leafVertices * leafVertexBytes +
           3 * sizeof(std::uint32_t) * counts.totalTriangles();
}

std::uint64_t meshBytes(const TreeCounts& counts) {
    constexpr double barkTiers = 2.0; // the coarser ones add up to at most the finest
    constexpr double leafTiers = 1.0 + 1.0 + 0.62 + 0.42 + 0.27; // shares of the clusters
    const auto clusters = static_cast<double>(counts.leafVertices / verticesPerLeafCluster);
    const auto bark = static_cast<double>(counts.skinVertices * packedBarkBytes +
                                          3 * sizeof(std::uint32_t) * counts.skinTriangles);
    return static_cast<std::uint64_t>(barkTiers * bark + leafTiers * clusters * leafRecordBytes) +
           3 * sizeof(std::uint32_t) * counts.leafTriangles;
}

std::size_t simulatedTreeBytes(ModalLevel level) {
    return sizeof(PlacedTree) + ModalMotion::treeBytes(level);
}

std::string problemOfMemory(const ForestDescription& description, bool withNodes) {
    const MemoryEstimate memory = estimateMemory(description);
    return problemOfTrees(description, memory.simulation + (withNodes ? memory.nodes : 0));
}

std::string problemOfMemory(const ForestDescription& description, const ShapeFamilies& families,
                            const std::vector<TreeCounts>& largest) {
    return problemOfTrees(description, estimateMemory(description, families, largest).simulation);
}

} // namespace osgTreeWind
