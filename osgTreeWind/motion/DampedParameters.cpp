// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/DampedParameters.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float pi = 3.14159265f;
constexpr float airDensity = 1.225f; // kg/m^3, standard atmosphere at sea level

/// Leaf area of each unit, m^2.
std::vector<float> leafAreas(const TreeModel& model, const TreeScale& scale, const LeafParameters& leaves) {
    std::vector<float> areas(model.skeleton.units.size());
    for (const LeafCluster& cluster : model.leaves) {
        const float size = cluster.size * scale.leaf;
        areas[static_cast<std::size_t>(cluster.unit)] += leaves.length * leaves.width * size * size;
    }
    return areas;
}

/// Where the drag on a branch acts, over its length: 3/8 for no taper, 0.263 at half.
float leverShare(float taper) {
    return 0.375f - 0.224f * (1.0f - std::clamp(taper, 0.0f, 1.0f));
}

} // namespace

std::vector<DampedParameters> makeDampedParameters(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    const std::vector<float> leafArea = leafAreas(model, scale, species.tree.leaves);
    const WoodParameters& wood = species.wood;
    std::vector<DampedParameters> parameters(units.size());
    std::vector<float> carriedMass(units.size()), carriedArea(units.size());

    for (std::size_t i = units.size(); i-- > 0;) { // children before parents
        const BranchUnit& unit = units[i];
        DampedParameters& p = parameters[i];
        const glm::vec3 span = scale.axes * (unit.tip - unit.base);
        const float length = std::max(glm::length(span), 1.0e-6f);
        const float d0 = std::max(2.0f * unit.baseRadius * scale.radius, 1.0e-6f);
        const float d1 = std::max(2.0f * unit.tipRadius * scale.radius, 1.0e-6f);
        p.direction = glm::length(span) > 0.0f ? glm::normalize(span) : glm::vec3(0.0f, 0.0f, 1.0f);
        p.maxAngle = species.branch.maxAngle;
        p.stiffness = 3.0f * pi * wood.elasticModulus * d0 * d0 * d0 * d1 / (64.0f * length);

        const float line = wood.density * pi / 4.0f * length; // mass over diameter squared
        const float leafMass = wood.leafMass * leafArea[i];
        // Wood: a truncated cone turning about its end; leaves: spread evenly along it.
        const float mass = line * (d0 * d0 + 3.0f * d0 * d1 + 6.0f * d1 * d1) / 30.0f + leafMass / 3.0f;
        p.inertia = (mass + carriedMass[i]) * length * length;
        p.damping = 2.0f * wood.dampingRatio * std::sqrt(p.stiffness * p.inertia);

        const float ownArea = wood.woodDrag * 0.5f * (d0 + d1) * length + wood.leafDrag * leafArea[i];
        const float ownLever = leverShare(d1 / d0) * length;
        const float moment = ownArea * ownLever + carriedArea[i] * length;
        const float square = ownArea * ownLever * ownLever + carriedArea[i] * length * length;
        if (moment > 0.0f) {
            p.lever = square / moment;
            p.drag = 0.5f * airDensity * moment / p.lever;
        }
        if (unit.parent >= 0) {
            const auto parent = static_cast<std::size_t>(unit.parent);
            carriedMass[parent] += carriedMass[i] + line * (d0 * d0 + d0 * d1 + d1 * d1) / 3.0f + leafMass;
            carriedArea[parent] += carriedArea[i] + ownArea;
        }
    }
    return parameters;
}

} // namespace osgTreeWind
