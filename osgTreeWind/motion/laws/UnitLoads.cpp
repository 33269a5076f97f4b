// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/LeafClusters.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Share of the drag of twigs that remains after they shelter each other. An oak in leaf then has 1.5 times
/// its bare load; measurements gave 1.8 to 3.2 times (Angelou et al. 2019).
constexpr float twigShelter = 0.5f;

/// Share of the tree's leaves per unit.
std::vector<float> leafShares(const TreeModel& model) {
    std::vector<float> shares(model.skeleton.units.size());
    float sum = 0.0f;
    for (const LeafCluster& cluster : model.leaves) {
        const float area = cluster.size * cluster.size;
        shares[static_cast<std::size_t>(cluster.unit)] += area;
        sum += area;
    }
    for (float& share : shares)
        share = sum > 0.0f ? share / sum : 0.0f;
    return shares;
}

/// Side view area of the crown, taken as a rhombus, m^2.
float crownOutline(const TreeModel& model, const TreeScale& scale) {
    if (model.leaves.empty())
        return 0.0f;
    glm::vec3 low = model.leaves.front().anchor, high = low;
    for (const LeafCluster& cluster : model.leaves) {
        low = glm::min(low, cluster.anchor);
        high = glm::max(high, cluster.anchor);
    }
    const glm::vec3 size = scale.axes * (high - low);
    return 0.25f * (size.x + size.y) * size.z;
}

/// Scales the mass of all branches to that of a real tree. A drawn conifer branch represents several side by
/// side, so its stiffness scales as well; sections of a drawn broadleaf add up, and only twigs are missing.
void scaleBranchMass(std::vector<UnitLoad>& loads, const std::vector<BranchUnit>& units,
                     const WoodParameters& wood, double diameter, double height) {
    double trunk = 0.0, drawn = 0.0;
    for (std::size_t i = 0; i < units.size(); ++i) {
        (units[i].level > 0 ? drawn : trunk) += loads[i].woodMass;
        drawn += loads[i].shootMass;
    }
    if (!(drawn > 0.0))
        return;
    const auto factor = static_cast<float>(branchWoodMass(wood, diameter, height, trunk, drawn) / drawn);
    for (std::size_t i = 0; i < units.size(); ++i) {
        loads[i].shootMass *= factor;
        if (units[i].level > 0) {
            loads[i].woodMass *= factor;
            if (wood.branchWood == WoodAllometry::Conifer)
                loads[i].modulus *= factor;
        }
    }
}

/// Loads carried by a unit, along its axis from its base.
struct CarriedLoad {
    float reach = 0.0f;   ///< Distance of the resultant of m r, but at least to the tip of the axis, metres.
    float moment = 0.0f;  ///< Sum of m r, kg m.
    float inertia = 0.0f; ///< Sum of m r^2, kg m^2.
};

std::vector<CarriedLoad> carriedBy(const std::vector<UnitLoad>& loads, const std::vector<BranchUnit>& units,
                                   const TreeScale& scale) {
    std::vector<CarriedLoad> carried(units.size());
    std::vector<glm::vec3> directions;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const ScaledUnit unit(units[i], scale);
        directions.push_back(unit.direction());
        const float mass = loads[i].mass();
        for (int a = static_cast<int>(i); a >= 0; a = units[static_cast<std::size_t>(a)].parent) {
            const auto carrier = static_cast<std::size_t>(a);
            const float arm = std::max(
                glm::dot(unit.middle() - scale.axes * units[carrier].base, directions[carrier]), 0.0f);
            carried[carrier].moment += mass * arm;
            carried[carrier].inertia += mass * arm * arm;
        }
    }
    const std::vector<float> reaches = distancesToAxisTip(units, scale);
    for (std::size_t i = 0; i < units.size(); ++i) {
        CarriedLoad& c = carried[i];
        c.reach = c.moment > 0.0f ? std::max(reaches[i], c.inertia / c.moment) : reaches[i];
    }
    return carried;
}

/// Sets the joint stiffness from the bent wood. A branch is at least stiff enough not to sag under its own
/// weight, for any number of units: twigs of a slender tree are not as slender as its trunk.
void addStiffness(std::vector<UnitLoad>& loads, const std::vector<BranchUnit>& units,
                  const TreeScale& scale) {
    constexpr float maxSag = 0.35f, g = static_cast<float>(gravity);
    const std::vector<CarriedLoad> carried = carriedBy(loads, units, scale);
    std::vector<float> branch = distancesToAxisTip(units, scale); // length of the one a unit is part of
    for (std::size_t i = 0; i < units.size(); ++i) {
        const ScaledUnit unit(units[i], scale);
        if (continuesParentAxis(units, i))
            branch[i] = branch[static_cast<std::size_t>(units[i].parent)];
        loads[i].stiffness = static_cast<float>(jointStiffness(
            loads[i].modulus, unit.baseDiameter, unit.tipDiameter, unit.length, carried[i].reach));
        if (units[i].level > 0)
            loads[i].stiffness =
                std::max(loads[i].stiffness, g * carried[i].moment * branch[i] / (maxSag * unit.length));
        if (loads[i].rootCompliance > 0.0f)
            loads[i].stiffness = 1.0f / (1.0f / loads[i].stiffness + loads[i].rootCompliance);
    }
}

} // namespace

double jointStiffness(double elasticModulus, double d0, double d1, double length, double reach) {
    const double q0 = reach / d0, q1 = (reach - length) / d1;
    return 3.0 * glm::pi<double>() * elasticModulus * d0 * d1 * reach * reach /
           (64.0 * length * (q0 * q0 + q0 * q1 + q1 * q1));
}

double breastDiameter(const TreeModel& model, const TreeScale& scale) {
    return std::sqrt(4.0 * static_cast<double>(trunkSection(model.skeleton, scale)) /
                     static_cast<double>(glm::pi<float>()));
}

float leafArea(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves) {
    return clampOr(leaves, 0.0f, 1.0f, 1.0f) * species.wood.leafArea * trunkSection(model.skeleton, scale);
}

std::vector<UnitLoad> makeAirLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                   float leaves) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    const WoodParameters& wood = species.wood;
    const std::vector<float> shares = leafShares(model);
    const bool isCrownMeasured = wood.crownDrag > 0.0f && !model.leaves.empty();
    const float share = clampOr(leaves, 0.0f, 1.0f, 1.0f);
    const auto diameter = static_cast<float>(breastDiameter(model, scale));
    const float height = scale.axes.z * model.skeleton.height();
    const double modulus = math::pow(static_cast<double>(wood.underBark), 4.0) *
                           stemModulus(wood, height / std::max(diameter, 1.0e-6f));
    const float area = leafArea(model, scale, species, share);
    const float crown = isCrownMeasured ? share * wood.crownDrag * math::pow(10.0f, -wood.streamlining) *
                                              crownOutline(model, scale)
                                        : wood.leafDrag * area;
    std::vector<UnitLoad> loads(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        const ScaledUnit unit(units[i], scale);
        const float d0 = unit.baseDiameter, d1 = unit.tipDiameter;
        loads[i].woodMass = wood.density * unit.volume();
        loads[i].modulus = static_cast<float>(units[i].level > 0 ? wood.branchModulus * modulus : modulus);
        loads[i].rootCompliance =
            units[i].parent < 0 ? static_cast<float>(rootCompliance(wood, diameter, height)) : 0.0f;
        loads[i].leafArea = area * shares[i];
        loads[i].leafMass = wood.leafMass * loads[i].leafArea;
        loads[i].leafDrag = crown * shares[i];
        loads[i].woodDrag = wood.woodDrag * 0.5f * (d0 + d1) * unit.length;
        if (!model.shootWood.empty()) {
            const ShootWood shoots = model.shootWood[i].scaled(scale.axes, scale.radius);
            loads[i].shootMass = wood.density * shoots.volume;
            loads[i].woodDrag += twigShelter * wood.woodDrag * shoots.outline;
        }
        if (isCrownMeasured && units[i].level > 0) // the measured drag of a crown includes its branches
            loads[i].woodDrag *= 1.0f - share;
    }
    return loads;
}

std::vector<UnitLoad> makeUnitLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                    float leaves) {
    std::vector<UnitLoad> loads = makeAirLoads(model, scale, species, leaves);
    scaleBranchMass(loads, model.skeleton.units, species.wood, breastDiameter(model, scale),
                    static_cast<double>(scale.axes.z * model.skeleton.height()));
    addStiffness(loads, model.skeleton.units, scale);
    return loads;
}

} // namespace osgTreeWind
