// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/MeshParts.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace osgTreeWind {
namespace {

constexpr std::size_t cardsPerPart = 32, trianglesPerPart = 192;
constexpr std::uint32_t indicesPerRun = 72; // neighbouring triangles of a skin that stay together

struct Box {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

void setBounds(MeshPart& part, const Box& box, float treeHeight) {
    part.centre = 0.5f * (box.low + box.high);
    part.halfExtent = 0.5f * (box.high - box.low);
    part.rise = math::pow(glm::clamp(part.centre.z / treeHeight, 0.0f, 1.0f), leanPower);
}

void split(const std::vector<glm::vec3>& places, std::size_t most, std::size_t first, std::size_t end,
           NearGroups& groups) {
    const auto begin = groups.order.begin();
    const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    if (end - first <= most) {
        std::sort(at(first), at(end));
        groups.ends.push_back(static_cast<std::uint32_t>(end));
        return;
    }
    Box box;
    std::for_each(at(first), at(end), [&](std::uint32_t item) { box.add(places[item]); });
    const glm::vec3 sides = box.high - box.low;
    const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
    const std::size_t middle = first + (end - first) / 2;
    std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(places[a][axis], a) < std::tie(places[b][axis], b);
    });
    split(places, most, first, middle, groups);
    split(places, most, middle, end, groups);
}

} // namespace

NearGroups groupNear(const std::vector<glm::vec3>& places, std::size_t most) {
    NearGroups groups;
    groups.order.resize(places.size());
    std::iota(groups.order.begin(), groups.order.end(), 0u);
    if (!places.empty())
        split(places, std::max<std::size_t>(most, 1), 0, places.size(), groups);
    return groups;
}

std::vector<MeshPart> sortIntoParts(ThinnedLeaves& leaves,
                                    const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                    float coverage, float treeHeight) {
    const auto quads = static_cast<std::size_t>(leaves.quads());
    std::vector<glm::vec3> places;
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i)
        places.push_back(leaves.middle(i, mesh));
    const NearGroups groups = groupNear(places, cardsPerPart / quads);
    const ThinnedLeaves before = leaves;
    std::vector<MeshPart> parts;
    std::size_t i = 0;
    for (const std::uint32_t end : groups.ends) {
        MeshPart part;
        part.firstIndex = static_cast<std::uint32_t>(6 * quads * i);
        part.indices = static_cast<std::uint32_t>(6 * quads * (end - i));
        Box box;
        for (; i < end; ++i) {
            const LeafCluster& leaf = before.clusters[groups.order[i]];
            leaves.clusters[i] = leaf;
            leaves.indices[i] = before.indices[groups.order[i]];
            const auto first = static_cast<std::size_t>(4 * leaves.firstQuad(i));
            for (std::size_t corner = first; corner < first + 4 * quads; ++corner) {
                box.add(leaf.anchor + leaf.size * (leaf.orientation * mesh[corner].corner));
                part.reach = glm::max(part.reach, leaf.size * glm::length(mesh[corner].corner));
            }
            part.area +=
                0.5f * coverage * leaf.size * leaf.size * areaOf(mesh, leaves.firstQuad(i), leaves.quads());
        }
        setBounds(part, box, treeHeight);
        parts.push_back(part);
    }
    return parts;
}

std::vector<MeshPart> sortIntoParts(BranchSkin& skin, float treeHeight) {
    struct Run {
        std::uint32_t first, end;
    };
    std::vector<Run> runs;
    std::vector<glm::vec3> places;
    for (std::size_t unit = 0; unit + 1 < skin.firstIndices.size(); ++unit)
        for (std::uint32_t i = skin.firstIndices[unit]; i < skin.firstIndices[unit + 1]; i += indicesPerRun) {
            const std::uint32_t end = std::min(i + indicesPerRun, skin.firstIndices[unit + 1]);
            glm::vec3 sum(0.0f);
            for (std::uint32_t at = i; at < end; ++at)
                sum += skin.vertices[skin.indices[at]].centre;
            places.push_back(sum / static_cast<float>(end - i));
            runs.push_back({i, end});
        }
    const NearGroups groups = groupNear(places, 3 * trianglesPerPart / indicesPerRun);
    std::vector<std::uint32_t> indices;
    indices.reserve(skin.indices.size());
    std::vector<MeshPart> parts;
    std::size_t run = 0;
    for (const std::uint32_t end : groups.ends) {
        MeshPart part;
        part.firstIndex = static_cast<std::uint32_t>(indices.size());
        Box box;
        for (; run < end; ++run)
            for (std::uint32_t i = runs[groups.order[run]].first; i < runs[groups.order[run]].end; i += 3) {
                glm::vec3 corners[3];
                for (std::uint32_t corner = 0; corner < 3; ++corner) {
                    indices.push_back(skin.indices[i + corner]);
                    corners[corner] = skin.vertices[indices.back()].position();
                    part.reach = glm::max(part.reach, skin.vertices[indices.back()].radius);
                    box.add(corners[corner]);
                }
                // A closed surface shows a quarter of its area on average (Cauchy).
                part.area +=
                    0.125f * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            }
        part.indices = static_cast<std::uint32_t>(indices.size()) - part.firstIndex;
        setBounds(part, box, treeHeight);
        parts.push_back(part);
    }
    skin.indices = std::move(indices);
    return parts;
}

} // namespace osgTreeWind
