// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FallingTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr double longestStep = 1.0 / 120.0;
constexpr double hangingAngle = 2.9; // radians from upright; a torn bough does not hang quite along the trunk
constexpr double supportShare = 0.25; // share of the half width at which branches hold a lying crown up

/// A unit and all its descendants.
std::vector<std::size_t> findDescendants(const std::vector<BranchUnit>& units, std::size_t unit) {
    std::vector<bool> falls(units.size(), false);
    std::vector<std::size_t> carried;
    for (std::size_t i = unit; i < units.size(); ++i) {
        falls[i] = i == unit || (units[i].parent >= 0 && falls[static_cast<std::size_t>(units[i].parent)]);
        if (falls[i])
            carried.push_back(i);
    }
    return carried;
}

/// Angle between a lying trunk and the ground, due to the crown below it, radians.
double crownSupportAngle(const TreeForm& tree, double length) {
    const std::array<float, 5> reach = tree.model->extents.reach(tree.scale);
    const double width = 0.25 * static_cast<double>(reach[0] + reach[1] + reach[2] + reach[3]);
    return std::clamp(math::atan(supportShare * width / (0.6 * length)), 0.0, 0.5);
}

} // namespace

FallingTree::FallingTree(const TreeForm& tree, unsigned unit, double moment, double lean) : _lean(lean) {
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    const std::vector<UnitLoad> loads = makeUnitLoads(*tree.model, tree.scale, *tree.species, tree.leaves);
    const glm::dvec3 hinge = tree.scale.axes * units[unit].base;
    const std::vector<std::size_t> carried = findDescendants(units, unit);
    const auto massOf = [&](std::size_t i) { return static_cast<double>(loads[i].mass()); };
    const auto placeOf = [&](std::size_t i) {
        return glm::dvec3(0.5f * tree.scale.axes * (units[i].base + units[i].tip)) - hinge;
    };
    glm::dvec3 weighed(0.0);
    for (const std::size_t i : carried)
        weighed += massOf(i) * placeOf(i);
    const double length = glm::length(weighed);
    const glm::dvec3 direction = length > 0.0 ? weighed / length : glm::dvec3(0.0, 0.0, 1.0);
    double inertia = 1.0e-3, drag = 0.0, reach = 0.1;
    for (const std::size_t i : carried) {
        const glm::dvec3 place = placeOf(i);
        const double out = std::max(glm::dot(place, direction), 0.0);
        inertia += massOf(i) * glm::dot(place, place);
        drag +=
            0.5 * static_cast<double>(airDensity * (loads[i].woodDrag + loads[i].leafDrag)) * out * out * out;
        reach = std::max(reach, glm::dot(glm::dvec3(tree.scale.axes * units[i].tip) - hinge, direction));
    }
    _weight = gravity * length / inertia;
    _push = moment / inertia;
    _drag = drag / inertia;
    if (units[unit].level == 0) { // a hinge above the ground lets the top swing below the hinge's level
        _rest = glm::half_pi<double>() + math::asin(std::min(hinge.z / reach, 0.5)) -
                crownSupportAngle(tree, reach);
        return;
    }
    _lean += math::acos(std::clamp(direction.z, -1.0, 1.0));
    _rest = std::max(hangingAngle - _lean, 0.0);
    const glm::dvec2 level(-direction.y, direction.x);
    if (glm::length(level) > 0.0)
        _axis = glm::normalize(level);
}

double FallingTree::swayShare() const {
    return isAtRest() ? 0.0 : math::cos(glm::half_pi<double>() * _angle / _rest);
}

void FallingTree::step(double seconds) {
    const int steps = std::max(1, static_cast<int>(std::ceil(seconds / longestStep)));
    const double step = seconds / steps;
    for (int i = 0; i < steps && !isAtRest(); ++i) {
        const double upright = std::max(math::cos(_angle), 0.0);
        const double pull = _push * upright * upright + _weight * math::sin(_angle + _lean);
        // Implicit drag, or a light crown would oscillate.
        _speed = (_speed + pull * step) / (1.0 + _drag * std::abs(_speed) * step);
        _angle = std::min(_angle + _speed * step, _rest);
    }
    if (isAtRest())
        _speed = 0.0;
}

} // namespace osgTreeWind
