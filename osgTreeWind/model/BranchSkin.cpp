// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/BranchSkin.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/JoinedSkin.h>
#include <osgTreeWind/model/ShootSkin.h>
#include <osgTreeWind/model/SkinParts.h>
#include <osgTreeWind/model/SkinPlan.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace osgTreeWind {
namespace {

/// @param start bark coordinate v at the base.
void addRings(const Skeleton& skeleton, std::size_t unit, int rings, int sides, float start,
              std::vector<SkinVertex>& vertices) {
    glm::vec3 e1 = perpendicular(skeleton.tangent(unit, 0));
    const float circumference = glm::two_pi<float>() * glm::max(skeleton.units[unit].baseRadius, 1e-6f);
    const float widening = ringWidening(sides);
    float along = 0.0f;
    for (int i = 0, before = 0; i < rings; ++i) {
        const int ring = i * (skeleton.ringsPerBranch - 1) / (rings - 1);
        const glm::vec3 tangent = skeleton.tangent(unit, ring);
        // Parallel transport, so that successive rings are not twisted.
        e1 = directionOr(e1 - tangent * glm::dot(e1, tangent), perpendicular(tangent));
        const glm::vec3 e2 = glm::cross(tangent, e1);
        along += glm::distance(skeleton.point(unit, ring), skeleton.point(unit, before));
        before = ring;
        for (int side = 0; side < sides; ++side) {
            const float part = static_cast<float>(side) / static_cast<float>(sides);
            const float angle = glm::two_pi<float>() * part;
            SkinVertex vertex;
            vertex.centre = skeleton.point(unit, ring);
            vertex.radius = skeleton.radius(unit, ring) * widening;
            vertex.outward = cosine(angle) * e1 + sine(angle) * e2;
            vertex.unit = static_cast<float>(unit);
            vertex.uv = {2.0f * part, start + along / circumference};
            vertices.push_back(vertex);
        }
    }
}

BranchSkin openTubes(const Skeleton& skeleton, float tolerance) {
    BranchSkin skin;
    const std::vector<SkinPlan> plans = planSkin(skeleton, tolerance);
    for (std::size_t unit = 0; unit < plans.size(); ++unit) {
        const SkinPlan& plan = plans[unit];
        addRings(skeleton, unit, plan.rings, plan.sides, barkStart(skeleton.units[unit], skin),
                 skin.vertices);
        finishUnit(skin, plan.rings, plan.sides);
    }
    return skin;
}

} // namespace

std::vector<SkinVertex> BranchSkin::drawOrder() const {
    std::vector<SkinVertex> ordered;
    ordered.reserve(indices.size());
    for (const std::uint32_t index : indices)
        ordered.push_back(vertices[index]);
    return ordered;
}

BranchSkin makeBranchSkin(const Skeleton& skeleton, float tolerance, float thinnestShoot) {
    BranchSkin skin = skeleton.joined ? makeJoinedSkin(skeleton, tolerance) : openTubes(skeleton, tolerance);
    addShootSkin(skeleton, tolerance, thinnestShoot, skin);
    return skin;
}

SkinSize sizeOfBranchSkin(const Skeleton& skeleton) {
    SkinSize size = sizeOfShootSkin(skeleton);
    for (const SkinPlan& plan : planSkin(skeleton, 0.0f)) {
        const auto rings = static_cast<std::uint64_t>(plan.rings),
                   sides = static_cast<std::uint64_t>(plan.sides);
        size.vertices += rings * sides + (plan.closed ? 1 : 0);
        size.triangles += 2 * (rings - 1) * sides + (plan.closed ? sides : 0);
    }
    return size;
}

} // namespace osgTreeWind
