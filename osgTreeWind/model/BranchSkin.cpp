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

/// How much wider the foot of a stem is that reaches as far up as `height` (Weber and Penn 1995, but over
/// below breast height), with a few roots that stand out.
class StemFoot {
public:
    explicit StemFoot(const Skeleton& skeleton)
        : _flare(skeleton.flare), _height(glm::min(0.1f * skeleton.height(), highest)) {}

    /// @param next height of the next ring: a foot that lies between two rings is not drawn.
    float widening(const BranchUnit& unit, float height, float next, float angle) const {
        if (_flare == 0.0f || unit.level > 0 || height >= _height || next > 1.5f * _height)
            return 1.0f;
        const float wider = 0.01f * (power(100.0f, 1.0f - glm::max(height, 0.0f) / _height) - 1.0f);
        return 1.0f + _flare * wider * (1.0f + rootDepth * sine(roots * angle));
    }

private:
    static constexpr float highest = 1.2f; ///< Metres.
    static constexpr float roots = 5.0f, rootDepth = 0.4f;
    float _flare, _height;
};

/// @param start bark coordinate at the base.
void addRings(const Skeleton& skeleton, std::size_t unit, const SkinDetail& detail, const StemFoot& foot,
              float start, std::vector<SkinVertex>& vertices) {
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
        const int next =
            glm::min(i + 1, detail.rings - 1) * (skeleton.ringsPerBranch - 1) / (detail.rings - 1);
        for (int side = 0; side < detail.sides; ++side) {
            const float part = static_cast<float>(side) / static_cast<float>(detail.sides);
            const float angle = glm::two_pi<float>() * part;
            SkinVertex vertex;
            vertex.centre = skeleton.point(unit, ring);
            vertex.radius = skeleton.radius(unit, ring) * widening *
                            foot.widening(skeleton.units[unit], skeleton.point(unit, ring).z,
                                          skeleton.point(unit, next).z, angle);
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
    const StemFoot foot(skeleton);
    BranchSkin skin;
    const auto rings = static_cast<std::uint32_t>(detail.rings);
    const auto sides = static_cast<std::uint32_t>(detail.sides);
    skin.indicesPerUnit = std::size_t{rings - 1} * sides * 6;
    skin.vertices.reserve(skeleton.units.size() * rings * sides);
    skin.indices.reserve(skeleton.units.size() * skin.indicesPerUnit);
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const auto start = static_cast<std::uint32_t>(skin.vertices.size());
        const BranchUnit& branch = skeleton.units[unit];
        const std::size_t end = static_cast<std::size_t>(branch.parent + 1) * rings * sides;
        // Bark goes on from where the branch springs.
        const float along = branch.parent < 0 ? 0.0f
                                              : glm::mix(skin.vertices[end - rings * sides].uv.y,
                                                         skin.vertices[end - 1].uv.y, branch.attach);
        addRings(skeleton, unit, detail, foot, along, skin.vertices);
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
