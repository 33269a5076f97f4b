// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/SkinPlan.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/SkinParts.h>
#include <osgTreeWind/model/StemFoot.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace osgTreeWind {
namespace {

constexpr float ringTolerance =
    2.0f; ///< Tolerance along a branch over that of its outline: it is less visible.
constexpr float minCollarRadius =
    0.012f; ///< Smallest radius of a branch whose collar has an additional ring, metres.

int fullSides(const Skeleton& skeleton, float radius) {
    if (!skeleton.joined)
        return BranchSkin::verticesPerRing;
    return radius >= 0.12f ? 20 : radius >= 0.05f ? 10 : radius >= 0.02f ? 8 : 6;
}

/// The smallest number of sides whose midpoints are within a tolerance of the circle.
int sidesWithin(float radius, float tolerance, int most) {
    for (const int sides : {3, 4, 6, 8, 12})
        if (sides < most &&
            radius * (1.0f - ringWidening(sides) * cosine(glm::pi<float>() / static_cast<float>(sides))) <
                tolerance)
            return sides;
    return most;
}

/// Whether a polyline of that many rings approximates a unit within a tolerance.
bool areRingsWithin(const Skeleton& skeleton, std::size_t unit, int rings, float tolerance) {
    const int last = skeleton.ringsPerBranch - 1;
    for (int i = 0; i + 1 < rings; ++i) {
        const int from = i * last / (rings - 1), to = (i + 1) * last / (rings - 1);
        const glm::vec3 start = skeleton.point(unit, from), along = skeleton.point(unit, to) - start;
        for (int ring = from + 1; ring < to; ++ring) {
            const float part = static_cast<float>(ring - from) / static_cast<float>(to - from);
            if (!(glm::distance(skeleton.point(unit, ring), start + part * along) < tolerance))
                return false;
        }
    }
    return true;
}

int ringsWithin(const Skeleton& skeleton, std::size_t unit, float tolerance, int fewest) {
    int rings = glm::min(fewest, skeleton.ringsPerBranch);
    while (rings < skeleton.ringsPerBranch &&
           (tolerance <= 0.0f || !areRingsWithin(skeleton, unit, rings, ringTolerance * tolerance)))
        ++rings;
    return rings;
}

} // namespace

std::vector<SkinPlan> planSkin(const Skeleton& skeleton, float tolerance) {
    std::vector<SkinPlan> plans;
    plans.reserve(skeleton.units.size());
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const bool stem = unit.parent < 0;
        SkinPlan plan;
        plan.sides = sidesWithin(unit.baseRadius, tolerance, fullSides(skeleton, unit.baseRadius));
        plan.fromEnd = skeleton.joined && !stem && unit.attach >= 1.0f;
        plan.closed = skeleton.joined && unit.tipRadius >= tolerance;
        const bool hasCollar = skeleton.joined && !stem && !plan.fromEnd &&
                               unit.baseRadius >= glm::max(minCollarRadius, 4.0f * tolerance);
        plan.rings = plan.skeletonRings = ringsWithin(skeleton, i, tolerance, hasCollar ? 3 : 2);
        if (plan.fromEnd) {
            SkinPlan& parent = plans[static_cast<std::size_t>(unit.parent)];
            parent.closed = false;
            int sides = parent.sides;
            while (sides % 2 == 0 && sides / 2 >= plan.sides)
                sides /= 2;
            plan.sides = sides;
        } else if (skeleton.joined && stem && StemFoot(skeleton).height() > 0.0f &&
                   skeleton.flare * unit.baseRadius > tolerance) {
            plan.rings += static_cast<int>(StemFoot::rings.size());
        } else if (hasCollar) {
            ++plan.rings;
        }
        plans.push_back(plan);
    }
    return plans;
}

} // namespace osgTreeWind
