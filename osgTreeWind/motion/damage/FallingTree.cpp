// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FallingTree.h>

#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr double quarterTurn = 1.5707963267948966, longestStep = 1.0 / 120.0;
constexpr double crushed = 0.25; // of the half width of a crown, boughs below it hold the trunk up

/// Angle between a trunk that lies and the ground, for the crown below it.
double heldUp(const SwayingTree& tree, double length) {
    const std::array<float, 5> reach = tree.model->extents.reach(tree.scale);
    const double width = 0.25 * static_cast<double>(reach[0] + reach[1] + reach[2] + reach[3]);
    return std::clamp(std::atan(crushed * width / (0.6 * length)), 0.0, 0.5);
}

} // namespace

FallingTree::FallingTree(const SwayingTree& tree, unsigned unit, double moment, double lean) : _lean(lean) {
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    const std::vector<UnitLoad> loads = makeUnitLoads(*tree.model, tree.scale, *tree.species, tree.leaves);
    const glm::vec3 hinge = tree.scale.axes * units[unit].base;
    std::vector<bool> falls(units.size(), false);
    double inertia = 0.0, weight = 0.0, drag = 0.0, length = 0.0;
    for (std::size_t i = unit; i < units.size(); ++i) {
        falls[i] = i == unit || (units[i].parent >= 0 && falls[static_cast<std::size_t>(units[i].parent)]);
        if (!falls[i])
            continue;
        const glm::vec3 at = 0.5f * tree.scale.axes * (units[i].base + units[i].tip) - hinge;
        const double up = std::max(static_cast<double>(at.z), 0.0);
        const double mass = static_cast<double>(loads[i].woodMass + loads[i].leafMass);
        inertia += mass * static_cast<double>(glm::dot(at, at));
        weight += mass * gravity * up;
        drag +=
            0.5 * static_cast<double>(airDensity * (loads[i].woodDrag + loads[i].leafDrag)) * up * up * up;
        length = std::max(length, static_cast<double>(tree.scale.axes.z * units[i].tip.z - hinge.z));
    }
    length = std::max(length, 0.1);
    inertia = std::max(inertia, 1.0e-3);
    _weight = weight / inertia;
    _push = moment / inertia;
    _drag = drag / inertia;
    // A hinge above the ground lets the top go down below it.
    _rest =
        quarterTurn + std::asin(std::min(static_cast<double>(hinge.z) / length, 0.5)) - heldUp(tree, length);
}

double FallingTree::sway() const {
    return lies() ? 0.0 : std::cos(quarterTurn * _angle / _rest);
}

void FallingTree::step(double seconds) {
    const int steps = std::max(1, static_cast<int>(std::ceil(seconds / longestStep)));
    const double step = seconds / steps;
    for (int i = 0; i < steps && !lies(); ++i) {
        const double upright = std::max(std::cos(_angle), 0.0);
        const double pull = _push * upright * upright + _weight * std::sin(_angle + _lean);
        // The drag of the end of the step, or a light crown would swing against it.
        _speed = (_speed + pull * step) / (1.0 + _drag * std::abs(_speed) * step);
        _angle = std::min(_angle + _speed * step, _rest);
    }
    if (lies())
        _speed = 0.0;
}

} // namespace osgTreeWind
