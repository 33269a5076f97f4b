// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeDetail.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// The van der Corput sequence: evenly distributed in [0, 1) over every range of indices.
double vanDerCorput(std::uint32_t index) {
    double value = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1, digit *= 0.5)
        value += (index & 1u) != 0 ? digit : 0.0;
    return value;
}

} // namespace

TreeDetail TreeDetail::reduced(int times) {
    constexpr TreeDetail details[reductions + 1] = {full(),
                                                    {0.0008f, 0.0003f, 1.0f, 1, 1.0f},
                                                    {0.0024f, 0.0006f, 1.0f, 2, 0.95f},
                                                    {0.0032f, 0.0008f, 0.62f, 2, 0.98f},
                                                    {0.0045f, 0.001f, 0.42f, 3, 1.15f},
                                                    {0.006f, 0.0014f, 0.27f, 4, 1.06f}};
    return details[glm::clamp(times, 0, reductions)];
}

ThinnedLeaves thinnedLeaves(const std::vector<LeafCluster>& leaves,
                            const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                            const TreeDetail& detail) {
    ThinnedLeaves thinned;
    thinned.bough = glm::clamp(detail.bough, 1, 4);
    double area = 0.0, kept = 0.0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const double size = static_cast<double>(leaves[i].size);
        area += quadsPerLeafCluster * size * size;
        const auto index = static_cast<std::uint32_t>(i);
        if (vanDerCorput(index) >= static_cast<double>(detail.leafShare))
            continue;
        kept += thinned.quads() * size * size;
        thinned.clusters.push_back(leaves[i]);
        thinned.indices.push_back(index);
    }
    if (kept <= 0.0)
        return thinned;
    const auto growth = static_cast<float>(std::sqrt(static_cast<double>(detail.leafArea) * area / kept));
    constexpr float beyond = 0.4f; // limits how far crowns grow outward
    const glm::vec3 before = middleOf(mesh, 0, quadsPerLeafCluster);
    float tip = 0.0f;
    for (const LeafVertex& v : mesh)
        tip = glm::max(tip, v.corner.z);
    const glm::vec3 inward{0.0f, 0.0f, 0.5f * beyond * (growth - 1.0f) * tip};
    for (std::size_t i = 0; i < thinned.clusters.size(); ++i) {
        LeafCluster& leaf = thinned.clusters[i];
        const glm::vec3 after = growth * middleOf(mesh, thinned.firstQuad(i), thinned.quads());
        leaf.anchor += leaf.size * (leaf.orientation * (before - after - inward));
        leaf.size *= growth;
    }
    return thinned;
}

glm::vec3 ThinnedLeaves::middle(std::size_t i,
                                const std::array<LeafVertex, verticesPerLeafCluster>& mesh) const {
    const LeafCluster& leaf = clusters[i];
    return leaf.anchor + leaf.size * (leaf.orientation * middleOf(mesh, firstQuad(i), quads()));
}

float areaOf(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int firstQuad, int quads) {
    float area = 0.0f;
    const auto end = static_cast<std::size_t>(4 * (firstQuad + quads));
    for (auto i = static_cast<std::size_t>(4 * firstQuad); i < end; i += 4)
        area +=
            glm::length(glm::cross(mesh[i + 1].corner - mesh[i].corner, mesh[i + 3].corner - mesh[i].corner));
    return area;
}

glm::vec3 middleOf(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int firstQuad, int quads) {
    glm::vec3 sum(0.0f);
    for (int i = 4 * firstQuad; i < 4 * (firstQuad + quads); ++i)
        sum += mesh[static_cast<std::size_t>(i)].corner;
    return sum / static_cast<float>(4 * quads);
}

BranchSkin thinnedSkin(const Skeleton& skeleton, const TreeDetail& detail) {
    const float radius = 0.5f * detail.thinnest * skeleton.height();
    const BranchSkin skin = makeBranchSkin(skeleton, detail.bark * skeleton.height(), radius);
    BranchSkin thinned;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        if (skeleton.units[unit].baseRadius >= radius)
            thinned.append(skin, unit);
        thinned.endUnit();
    }
    return thinned;
}

} // namespace osgTreeWind
