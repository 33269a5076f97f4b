// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/LeafOrders.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace osgTreeWind {
namespace {

using Middles = std::vector<glm::vec3>;

Middles quadMiddles(const ThinnedLeaves& leaves, const std::array<LeafVertex, verticesPerLeafCluster>& mesh) {
    Middles middles;
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i)
        for (int quad = leaves.firstQuad(i); quad < leaves.firstQuad(i) + leaves.quads(); ++quad) {
            const LeafCluster& leaf = leaves.clusters[i];
            middles.push_back(leaf.anchor + leaf.size * (leaf.orientation * middleOf(mesh, quad, 1)));
        }
    return middles;
}

/// Sorts quads into a few slabs by their distance along a direction, the farthest first. Within a slab they
/// keep their order, branch by branch, because vertices out of order cost more than hidden cards.
std::vector<unsigned> sortInSlabs(const Middles& middles, const glm::vec3& direction) {
    constexpr float slabs = 8.0f;
    std::vector<float> along;
    for (const glm::vec3& middle : middles)
        along.push_back(glm::dot(middle, direction));
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    const float perSlab = slabs / glm::max(*high - *low, 1e-6f), end = *high;
    const auto slab = [&](unsigned quad) { return static_cast<int>(perSlab * (end - along[quad])); };
    std::vector<unsigned> quads(middles.size());
    std::iota(quads.begin(), quads.end(), 0u);
    std::stable_sort(quads.begin(), quads.end(), [&](unsigned a, unsigned b) { return slab(a) < slab(b); });
    return quads;
}

} // namespace

const std::array<glm::vec3, LeafOrders::count>& LeafOrders::directions() {
    static const std::array<glm::vec3, count> all = [] {
        std::array<glm::vec3, count> made{glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(0.0f, 0.0f, -1.0f)};
        for (std::size_t i = 2; i < count; ++i) {
            const float turn = static_cast<float>(i - 2) / static_cast<float>(count - 2);
            const float azimuth = glm::two_pi<float>() * turn;
            made[i] = {glm::cos(azimuth), glm::sin(azimuth), 0.0f};
        }
        return made;
    }();
    return all;
}

std::size_t LeafOrders::nearest(const glm::vec3& toEye) {
    const auto& all = directions();
    const auto best = std::max_element(all.begin(), all.end(), [&](const glm::vec3& a, const glm::vec3& b) {
        return glm::dot(a, toEye) < glm::dot(b, toEye);
    });
    return static_cast<std::size_t>(best - all.begin());
}

LeafOrders::Geometries LeafOrders::make(const osg::Geometry& geometry, const ThinnedLeaves& leaves,
                                        const std::array<LeafVertex, verticesPerLeafCluster>& mesh) {
    const Middles middles = quadMiddles(leaves, mesh);
    const bool isShort = 4 * middles.size() <= 65536;
    Geometries orders;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<unsigned> indices;
        if (!middles.empty())
            indices = leafIndices(sortInSlabs(middles, directions()[i]));
        orders[i] = new osg::Geometry(geometry, osg::CopyOp::SHALLOW_COPY);
        if (isShort)
            orders[i]->setPrimitiveSet(
                0, new osg::DrawElementsUShort(GL_TRIANGLES, indices.begin(), indices.end()));
        else
            orders[i]->setPrimitiveSet(
                0, new osg::DrawElementsUInt(GL_TRIANGLES, indices.begin(), indices.end()));
    }
    return orders;
}

} // namespace osgTreeWind
