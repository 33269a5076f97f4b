// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeDetail.h>

#include <glm/common.hpp>

#include <cmath>
#include <utility>

namespace osgTreeWind {
namespace {

/// Middle of the first quads of a cluster.
glm::vec3 middle(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int quads) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < 4 * quads; ++i)
        sum += mesh[static_cast<std::size_t>(i)].corner;
    return sum / static_cast<float>(4 * quads);
}

/// Van der Corput's: in every run of indices even in [0, 1).
double evenly(std::uint32_t index) {
    double value = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1, digit *= 0.5)
        value += (index & 1u) != 0 ? digit : 0.0;
    return value;
}

} // namespace

TreeDetail TreeDetail::reduced(int times) {
    constexpr TreeDetail details[reductions] = {{{5, 5}, 0.0006f, 1.0f, 2, 1.15f},
                                                {{4, 4}, 0.0009f, 0.55f, 2, 1.15f},
                                                {{3, 4}, 0.0012f, 0.33f, 3, 1.15f},
                                                {{2, 3}, 0.0016f, 0.19f, 4, 1.2f}};
    return details[glm::clamp(times, 1, reductions) - 1];
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
        if (evenly(index) >= static_cast<double>(detail.leafShare))
            continue;
        kept += thinned.quads() * size * size;
        thinned.clusters.push_back(leaves[i]);
        thinned.indices.push_back(index);
    }
    if (kept <= 0.0)
        return thinned;
    const auto growth = static_cast<float>(std::sqrt(static_cast<double>(detail.leafArea) * area / kept));
    const glm::vec3 before = middle(mesh, quadsPerLeafCluster),
                    after = growth * middle(mesh, thinned.quads());
    for (LeafCluster& leaf : thinned.clusters) {
        leaf.anchor += leaf.size * (leaf.orientation * (before - after));
        leaf.size *= growth;
    }
    return thinned;
}

BranchSkin thinnedSkin(const Skeleton& skeleton, const TreeDetail& detail) {
    BranchSkin skin = makeBranchSkin(skeleton, detail.skin);
    if (detail.thinnest <= 0.0f)
        return skin;
    const float radius = 0.5f * detail.thinnest * skeleton.height();
    const auto isThin = [&](std::uint32_t vertex) {
        return skeleton.units[static_cast<std::size_t>(skin.vertices[vertex].unit)].baseRadius < radius;
    };
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < skin.indices.size(); i += 3)
        if (!isThin(skin.indices[i]))
            indices.insert(indices.end(), skin.indices.begin() + static_cast<std::ptrdiff_t>(i),
                           skin.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
    std::vector<std::uint32_t> moved(skin.vertices.size(), ~0u);
    std::vector<SkinVertex> vertices;
    for (std::uint32_t& index : indices) {
        if (moved[index] == ~0u) {
            moved[index] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(skin.vertices[index]);
        }
        index = moved[index];
    }
    return {std::move(vertices), std::move(indices), 0};
}

} // namespace osgTreeWind
