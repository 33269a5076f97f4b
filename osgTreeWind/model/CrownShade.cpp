// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownShade.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vector_relational.hpp>

namespace osgTreeWind {
namespace {

/// A cell of a grid, and a position in it, [0, 1].
struct GridPlace {
    glm::ivec3 cell;
    glm::vec3 part;

    GridPlace(const glm::vec3& place, int cells) {
        const glm::vec3 inside = glm::clamp(place, glm::vec3(0.0f), glm::vec3(static_cast<float>(cells)));
        cell = glm::min(glm::ivec3(inside), glm::ivec3(cells - 1));
        part = inside - glm::vec3(cell);
    }
    /// Calls use(node, weight) for the eight nodes around it.
    template <typename Use>
    void eachNode(int nodes, Use use) const {
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
            const glm::vec3 w = glm::mix(1.0f - part, part, glm::vec3(corner));
            const glm::ivec3 at = cell + corner;
            use(static_cast<std::size_t>((at.z * nodes + at.y) * nodes + at.x), w.x * w.y * w.z);
        }
    }
};

} // namespace

glm::ivec3 CrownShade::direction(std::size_t index) {
    const int i = static_cast<int>(index), sign = index % 2 ? -1 : 1;
    if (i < 6)
        return {i / 2 == 0 ? sign : 0, i / 2 == 1 ? sign : 0, i / 2 == 2 ? sign : 0};
    return {i & 1 ? -1 : 1, (i - 6) & 2 ? -1 : 1, (i - 6) & 4 ? -1 : 1};
}

CrownShade::CrownShade(const std::vector<LeafCluster>& leaves,
                       const std::array<LeafVertex, verticesPerLeafCluster>& mesh, float coverage) {
    if (leaves.empty())
        return;
    glm::vec3 middle(0.0f);
    for (const LeafVertex& vertex : mesh)
        middle += vertex.corner / static_cast<float>(verticesPerLeafCluster);
    const auto placeOf = [&](const LeafCluster& leaf) {
        return leaf.anchor + leaf.size * (leaf.orientation * middle);
    };
    glm::vec3 low(1e9f), high(-1e9f), first(0.0f), last(0.0f); // bounds of the anchors; of the tree
    for (const LeafCluster& leaf : leaves) {
        low = glm::min(low, leaf.anchor);
        high = glm::max(high, leaf.anchor);
        first = glm::min(first, placeOf(leaf));
        last = glm::max(last, placeOf(leaf));
    }
    _middle = 0.5f * (low + high);
    _halfAxes = glm::max(0.5f * (high - low), glm::vec3(1e-3f));
    _low = first;
    _cell = glm::max((last - first) / static_cast<float>(cells), glm::vec3(1e-3f));

    std::vector<float> density(nodes * nodes * nodes, 0.0f);                   // m^2 per m^3
    float size = 0.0f, area = coverage * areaOf(mesh, 0, quadsPerLeafCluster); // area of a cluster
    for (const LeafCluster& leaf : leaves)
        size += leaf.size * leaf.size;
    area = glm::min(area, maxLeafArea * glm::pi<float>() * _halfAxes.x * _halfAxes.y / size);
    for (const LeafCluster& leaf : leaves)
        for (std::size_t i = 0; i < mesh.size(); ++i) { // a quarter of a quad
            const glm::vec3 point = 0.5f * (middleOf(mesh, static_cast<int>(i / 4), 1) + mesh[i].corner);
            addArea(leaf.anchor + leaf.size * (leaf.orientation * point),
                    area * leaf.size * leaf.size / verticesPerLeafCluster, density);
        }
    for (std::size_t i = 0; i < density.size(); ++i) {
        const glm::ivec3 at(i % nodes, i / nodes % nodes, i / (nodes * nodes));
        glm::vec3 size = _cell;
        for (int axis = 0; axis < 3; ++axis)
            if (at[axis] == 0 || at[axis] == cells)
                size[axis] *= 0.5f;
        density[i] /= size.x * size.y * size.z;
    }
    _depths.resize(density.size());
    for (std::size_t d = 0; d < directions; ++d)
        integrate(density, d);
}

void CrownShade::addArea(const glm::vec3& point, float area, std::vector<float>& areas) const {
    GridPlace((point - _low) / _cell, cells).eachNode(nodes, [&](std::size_t node, float weight) {
        areas[node] += weight * area;
    });
}

void CrownShade::integrate(const std::vector<float>& density, std::size_t direction) {
    const glm::ivec3 way = CrownShade::direction(direction);
    const float half = 0.5f * glm::length(glm::vec3(way) * _cell);
    const int step = (way.z * nodes + way.y) * nodes + way.x;
    for (int k = 0; k < nodes * nodes * nodes; ++k) { // starts where the direction leaves the grid
        const glm::ivec3 order(k % nodes, k / nodes % nodes, k / (nodes * nodes));
        const glm::ivec3 at = glm::mix(order, cells - order, glm::greaterThan(way, glm::ivec3(0)));
        const glm::ivec3 next = at + way;
        const auto node = static_cast<std::size_t>((at.z * nodes + at.y) * nodes + at.x);
        const bool inside = glm::all(glm::greaterThanEqual(next, glm::ivec3(0))) &&
                            glm::all(glm::lessThanEqual(next, glm::ivec3(cells)));
        if (!inside) {
            _depths[node][direction] = 0.0f;
            continue;
        }
        const auto before = static_cast<std::size_t>(static_cast<int>(node) + step);
        _depths[node][direction] = _depths[before][direction] + half * (density[node] + density[before]);
    }
}

CrownShade::Light CrownShade::at(const glm::vec3& point) const {
    Light light;
    if (_depths.empty())
        return light;
    Depths depths{};
    GridPlace((point - _low) / _cell, cells).eachNode(nodes, [&](std::size_t node, float weight) {
        for (std::size_t d = 0; d < directions; ++d)
            depths[d] += weight * _depths[node][d];
    });
    static const float attenuation = projection * clumping * glm::sqrt(1.0f - scattering);
    light.sky = light.ground = 0.0f;
    for (std::size_t d = 0; d < directions; ++d) {
        const float left = math::exp(-attenuation * depths[d]);
        if (d < 6)
            (d % 2 ? light.below : light.above)[static_cast<int>(d / 2)] = left;
        // Quadrature of the sphere with 14 points (Lebedev 1976).
        const int up = direction(d).z;
        const float weight = (d < 6 ? 2.0f / 15.0f : 3.0f / 20.0f) * left;
        light.sky += 0.5f * static_cast<float>(1 + up) * weight;
        light.ground += 0.5f * static_cast<float>(1 - up) * weight;
    }
    return light;
}

glm::vec3 CrownShade::outward(const glm::vec3& point) const {
    const glm::vec3 inside = (point - _middle) / _halfAxes;
    return glm::normalize(inside / _halfAxes + glm::vec3(0, 0, 1e-3f));
}

} // namespace osgTreeWind
