// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeDetail.h>

#include <glm/common.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Middle of the first quads of a cluster.
glm::vec3 middle(const std::array<LeafVertex, verticesPerLeafCluster>& mesh, int quads) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < 4 * quads; ++i)
        sum += mesh[static_cast<std::size_t>(i)].corner;
    return sum / static_cast<float>(4 * quads);
}

} // namespace

ThinnedLeaves thinnedLeaves(const std::vector<LeafCluster>& leaves,
                            const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                            const TreeDetail& detail) {
    ThinnedLeaves thinned;
    thinned.quads = glm::clamp(detail.quads, 1, quadsPerLeafCluster);
    const double share = glm::clamp(static_cast<double>(detail.leafShare), 0.0, 1.0);
    double area = 0.0, kept = 0.0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const double size = static_cast<double>(leaves[i].size);
        area += quadsPerLeafCluster * size * size;
        const double place = share * static_cast<double>(i) + 0.5;
        if (std::floor(place + share) == std::floor(place))
            continue;
        kept += thinned.quads * size * size;
        thinned.clusters.push_back(leaves[i]);
        thinned.indices.push_back(static_cast<std::uint32_t>(i));
    }
    if (kept <= 0.0)
        return thinned;
    const auto growth = static_cast<float>(std::sqrt(static_cast<double>(detail.leafArea) * area / kept));
    thinned.textureBias = 0.85f * std::log2(growth); // fitted to pictures of six species
    const glm::vec3 before = middle(mesh, quadsPerLeafCluster), after = growth * middle(mesh, thinned.quads);
    for (LeafCluster& leaf : thinned.clusters) {
        leaf.anchor += leaf.size * (leaf.orientation * (before - after));
        leaf.size *= growth;
    }
    return thinned;
}

} // namespace osgTreeWind
