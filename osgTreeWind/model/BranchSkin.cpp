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

/// Perimeter of a regular polygon over its radius: its mean width, but for a factor.
float perimeter(int sides) {
    return static_cast<float>(sides) * sine(glm::pi<float>() / static_cast<float>(sides));
}

/// @param start bark coordinate at the base.
void addRings(const Skeleton& skeleton, std::size_t unit, const SkinDetail& detail, float start,
              std::vector<SkinVertex>& vertices) {
    glm::vec3 e1 = perpendicular(skeleton.tangent(unit, 0));
    const float circumference = glm::two_pi<float>() * glm::max(skeleton.units[unit].baseRadius, 1e-6f);
    const float widening = perimeter(BranchSkin::verticesPerRing) / perimeter(detail.sides);
    float along = 0.0f;
    for (int i = 0, before = 0; i < detail.rings; ++i) {
        const int ring = i * (skeleton.ringsPerBranch - 1) / (detail.rings - 1);
        const glm::vec3 tangent = skeleton.tangent(unit, ring);
        // Carried along, so that rings do not turn against each other.
        e1 = directionOr(e1 - tangent * glm::dot(e1, tangent), perpendicular(tangent));
        const glm::vec3 e2 = glm::cross(tangent, e1);
        along += glm::distance(skeleton.point(unit, ring), skeleton.point(unit, before));
        before = ring;
        for (int side = 0; side < detail.sides; ++side) {
            const float part = static_cast<float>(side) / static_cast<float>(detail.sides);
            const float angle = glm::two_pi<float>() * part;
            SkinVertex vertex;
            vertex.centre = skeleton.point(unit, ring);
            vertex.radius = skeleton.radius(unit, ring) * widening;
            vertex.outward = cosine(angle) * e1 + sine(angle) * e2;
            vertex.unit = static_cast<float>(unit);
            // There and back again, so that the bark closes without a seam on its few vertices.
            vertex.uv.x = 1.0f - std::abs(1.0f - 2.0f * part);
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

BranchSkin makeBranchSkin(const Skeleton& skeleton, const SkinDetail& wanted) {
    const SkinDetail detail{glm::clamp(wanted.rings, 2, skeleton.ringsPerBranch), glm::max(wanted.sides, 3)};
    BranchSkin skin;
    const auto rings = static_cast<std::uint32_t>(detail.rings);
    const auto sides = static_cast<std::uint32_t>(detail.sides);
    skin.indicesPerUnit = std::size_t{rings - 1} * sides * 6;
    skin.vertices.reserve(skeleton.units.size() * rings * sides);
    skin.indices.reserve(skeleton.units.size() * skin.indicesPerUnit);
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const auto start = static_cast<std::uint32_t>(skin.vertices.size());
        const int parent = skeleton.units[unit].parent;
        const std::size_t end = static_cast<std::size_t>(parent + 1) * rings * sides;
        // Bark goes on where the parent's ends.
        addRings(skeleton, unit, detail, parent < 0 ? 0.0f : skin.vertices[end - 1].uv.y, skin.vertices);
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
