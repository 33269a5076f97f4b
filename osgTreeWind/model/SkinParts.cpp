// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/SkinParts.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

namespace osgTreeWind {
namespace {

/// Perimeter of a regular polygon over twice its radius; proportional to its mean width.
float perimeter(int sides) {
    return static_cast<float>(sides) * sine(glm::pi<float>() / static_cast<float>(sides));
}

} // namespace

float ringWidening(int sides) {
    return perimeter(BranchSkin::verticesPerRing) / perimeter(sides);
}

float barkStart(const BranchUnit& unit, const BranchSkin& skin) {
    if (unit.parent < 0)
        return 0.0f;
    const auto parent = static_cast<std::size_t>(unit.parent);
    return glm::mix(skin.vertices[skin.firstVertices[parent]].uv.y,
                    skin.vertices[skin.firstVertices[parent + 1] - 1].uv.y, unit.attach);
}

void addRingTriangles(BranchSkin& skin, std::size_t firstVertex, int rings, int sides, bool closed) {
    const auto around = static_cast<std::uint32_t>(sides);
    auto ring = static_cast<std::uint32_t>(firstVertex);
    for (int i = 1; i < rings; ++i, ring += around)
        for (std::uint32_t side = 0; side < around; ++side) {
            const std::uint32_t a = ring + side, b = ring + (side + 1) % around;
            skin.indices.insert(skin.indices.end(), {a, b, b + around, a, b + around, a + around});
        }
    for (std::uint32_t side = 0; closed && side < around; ++side)
        skin.indices.insert(skin.indices.end(), {ring + side, ring + (side + 1) % around, ring + around});
}

void finishUnit(BranchSkin& skin, int rings, int sides, bool closed) {
    addRingTriangles(skin, skin.firstVertices.back(), rings, sides, closed);
    skin.firstVertices.push_back(static_cast<std::uint32_t>(skin.vertices.size()));
    skin.firstIndices.push_back(static_cast<std::uint32_t>(skin.indices.size()));
}

} // namespace osgTreeWind
