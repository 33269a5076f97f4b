// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/PullAndRelease.h>

#include <osgTreeWind/motion/BranchwiseMotion.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double pull = 0.01; // of the trunk's height
constexpr double step = 1.0 / 60.0;
constexpr double longest = 600.0; // seconds
constexpr std::size_t halfSwings = 6;

/// The last unit of the trunk.
std::size_t topOf(const Skeleton& skeleton) {
    std::size_t top = 0;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        if (skeleton.units[i].level == 0)
            top = i;
    return top;
}

/// Angles of a trunk that a force at its top bends that far toward +x.
std::vector<glm::vec4> pulledStates(const ForestSimulation& simulation, std::size_t top) {
    const PlacedTree& tree = simulation.trees().front();
    const std::vector<BranchUnit>& units = simulation.models()[tree.model].skeleton.units;
    const auto reach = [&](std::size_t i) {
        return tree.scale.axes.z * (units[top].tip.z - units[i].base.z);
    };
    const auto compliance = [&](std::size_t i) {
        return reach(i) / simulation.branches()->dampedBranches()[i].stiffness;
    };
    float shift = 0.0f; // under 1 N
    for (std::size_t i = 0; i <= top; ++i)
        if (units[i].level == 0)
            shift += reach(i) * compliance(i);
    const float force = static_cast<float>(pull) * reach(0) / shift;
    std::vector<glm::vec4> states(units.size(), glm::vec4(0.0f));
    for (std::size_t i = 0; i <= top; ++i)
        if (units[i].level == 0)
            states[i].x = force * compliance(i);
    return states;
}

} // namespace

std::optional<FreeSway> pullAndRelease(const Species& species, const TreePlacement& tree) {
    ForestDescription forest;
    forest.species = {species};
    forest.trees = {tree};
    forest.trees[0].species = 0;
    ForestSimulation simulation(std::move(forest));
    const PlacedTree& grown = simulation.trees().front();
    const Skeleton& skeleton = simulation.models()[grown.model].skeleton;
    const std::size_t top = topOf(skeleton);
    const glm::vec3 rest = grown.scale.axes * skeleton.units[top].tip;

    simulation.branches()->setStates(pulledStates(simulation, top).data());
    simulation.advance(0.0);
    const Span<UnitPose> poses = simulation.motion(0).poses;
    std::vector<double> crossings, peaks;
    double before = poses[top].apply(rest).x - rest.x, peak = 0.0;
    for (double time = step; time < longest && crossings.size() <= halfSwings; time += step) {
        simulation.advance(time);
        const double now = poses[top].apply(rest).x - rest.x;
        if ((before > 0.0) != (now > 0.0)) {
            if (!crossings.empty())
                peaks.push_back(peak);
            crossings.push_back(time - step * now / (now - before));
            peak = 0.0;
        }
        peak = std::max(peak, std::abs(now));
        before = now;
    }
    if (crossings.size() <= halfSwings)
        return {};
    FreeSway sway;
    sway.frequency = 0.5 * static_cast<double>(halfSwings) / (crossings.back() - crossings.front());
    const double decrement =
        std::log(peaks.front() / peaks.back()) / static_cast<double>(peaks.size() - 1); // of half a swing
    sway.dampingRatio = decrement / std::hypot(glm::pi<double>(), decrement);
    return sway;
}

} // namespace osgTreeWind
