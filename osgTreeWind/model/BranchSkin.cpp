// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/BranchSkin.h>

#include <osgTreeWind/model/PortableMath.h>
#include <osgTreeWind/model/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int sides = BranchSkin::verticesPerRing;

/// @param start bark coordinate at the base.
void addRings(const Skeleton& skeleton, std::size_t unit, float start, std::vector<SkinVertex>& vertices) {
    glm::vec3 e1 = perpendicular(skeleton.tangent(unit, 0));
    const float circumference = glm::two_pi<float>() * glm::max(skeleton.units[unit].baseRadius, 1e-6f);
    float along = 0.0f;
    for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring) {
        const glm::vec3 tangent = skeleton.tangent(unit, ring);
        // Carried along, so that rings do not turn against each other.
        e1 = directionOr(e1 - tangent * glm::dot(e1, tangent), perpendicular(tangent));
        const glm::vec3 e2 = glm::cross(tangent, e1);
        if (ring > 0)
            along += glm::distance(skeleton.point(unit, ring), skeleton.point(unit, ring - 1));
        for (int side = 0; side < sides; ++side) {
            const float angle = glm::two_pi<float>() * static_cast<float>(side) / static_cast<float>(sides);
            SkinVertex vertex;
            vertex.centre = skeleton.point(unit, ring);
            vertex.radius = skeleton.radius(unit, ring);
            vertex.outward = cosine(angle) * e1 + sine(angle) * e2;
            vertex.unit = static_cast<float>(unit);
            // There and back again, so that the bark closes without a seam on eight vertices.
            vertex.uv.x = 1.0f - std::abs(1.0f - 2.0f * static_cast<float>(side) / static_cast<float>(sides));
            vertex.uv.y = start + along / circumference;
            vertices.push_back(vertex);
        }
    }
}

} // namespace

std::vector<SkinVertex> BranchSkin::drawOrder() const {
    std::vector<SkinVertex> ordered;
    ordered.reserve(indices.size());
    for (const std::uint32_t index : indices)
        ordered.push_back(vertices[index]);
    return ordered;
}

BranchSkin makeBranchSkin(const Skeleton& skeleton) {
    BranchSkin skin;
    const auto rings = static_cast<std::size_t>(skeleton.ringsPerBranch);
    skin.indicesPerUnit = (rings - 1) * sides * 6;
    skin.vertices.reserve(skeleton.units.size() * rings * sides);
    skin.indices.reserve(skeleton.units.size() * skin.indicesPerUnit);
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const auto start = static_cast<std::uint32_t>(skin.vertices.size());
        const int parent = skeleton.units[unit].parent;
        const std::size_t end = (static_cast<std::size_t>(parent + 1) * rings) * sides;
        // Bark goes on where the parent's ends.
        addRings(skeleton, unit, parent < 0 ? 0.0f : skin.vertices[end - 1].uv.y, skin.vertices);
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            for (std::uint32_t side = 0; side < sides; ++side) {
                const std::uint32_t a = start + ring * sides + side;
                const std::uint32_t b = start + ring * sides + (side + 1) % sides;
                for (const std::uint32_t index : {a, b, b + sides, a, b + sides, a + sides})
                    skin.indices.push_back(index);
            }
        }
    }
    return skin;
}

} // namespace osgTreeWind
