// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/WindDamage.h>

#include <osgTreeWind/motion/damage/FootMoment.h>
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr std::size_t batch = 256;
constexpr float stump = 1.3f; // metres; TreeStrength

SwayingTree formOf(const PlacedForest& forest, const PlacedTree& tree) {
    return {&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves};
}

/// The unit of its trunk above which it snaps: the first joint from breast height on.
unsigned unitAtBreast(const PlacedForest& forest, const PlacedTree& tree) {
    const std::vector<BranchUnit>& units = forest.modelOf(tree).skeleton.units;
    unsigned joint = 0;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0) {
            joint = static_cast<unsigned>(i);
            if (tree.scale.axes.z * units[i].base.z >= stump)
                break;
        }
    return joint;
}

glm::vec3 meanWind(const ModalMotion& sway, std::size_t slot, const PlacedTree& tree) {
    glm::vec3 winds[ModalDetail::maxPatches];
    sway.patchWinds(slot, winds);
    glm::vec3 sum(0.0f);
    const std::size_t patches = sway.model(slot).patches.size();
    for (std::size_t patch = 0; patch < patches; ++patch)
        sum += winds[patch];
    return turnHeading(sum / static_cast<float>(std::max<std::size_t>(patches, 1)), std::sin(tree.heading),
                       std::cos(tree.heading));
}

} // namespace

void WindDamage::meet(const PlacedForest& forest, const ModalMotion& sway, std::size_t slot, float seconds,
                      Limits& limits) {
    const PlacedTree& tree = forest.trees[slot];
    if (limits.stiffness == 0.0f) {
        const TreeStrength strength(forest.modelOf(tree), tree.scale, forest.speciesOf(tree));
        limits.uproot = static_cast<float>(strength.uproot);
        limits.breaking = static_cast<float>(strength.breaking);
        limits.stiffness = static_cast<float>(FootMoment(formOf(forest, tree)).stiffness());
    }
    limits.age += seconds;
    if (sway.lean(slot) == limits.lean)
        return;
    limits.lean = sway.lean(slot);
    limits.moment = static_cast<float>(FootMoment(limits.stiffness).of(sway, slot)) /
                    std::max(forest.description().gain, 1.0e-3f);
}

void WindDamage::follow(const PlacedForest& forest, ModalMotion& sway, float seconds,
                        const Executor& executor) {
    _broken.clear();
    _limits.resize(forest.trees.size());
    const auto meetBatch = [&](std::size_t job) {
        for (std::size_t slot = job * batch; slot < std::min(_limits.size(), (job + 1) * batch); ++slot)
            if (forest.trees[slot].alive && !_limits[slot].isDown)
                meet(forest, sway, slot, seconds, _limits[slot]);
    };
    (executor ? executor : Executor(runInTurn))((_limits.size() + batch - 1) / batch, meetBatch);
    for (std::size_t slot = 0; slot < _limits.size(); ++slot) {
        const Limits& limits = _limits[slot];
        const auto exceeds = [&](float limit) { return limit > 0.0f && limits.moment > limit; };
        if (forest.trees[slot].alive && !limits.isDown && limits.age > settling &&
            (exceeds(limits.uproot) || exceeds(limits.breaking)))
            fell(forest, sway, slot);
    }
    for (auto each = _falling.begin(); each != _falling.end();) {
        Falling& falling = each->second;
        falling.body.step(static_cast<double>(seconds));
        sway.setFall(each->first, {falling.unit, static_cast<float>(falling.body.angle()) * falling.axis,
                                   static_cast<float>(falling.body.sway())});
        each = falling.body.lies() ? _falling.erase(each) : std::next(each);
    }
}

void WindDamage::fell(const PlacedForest& forest, const ModalMotion& sway, std::size_t slot) {
    Limits& limits = _limits[slot];
    const PlacedTree& tree = forest.trees[slot];
    TreeDamage damage;
    damage.tree = forest.idOf(slot);
    const bool roots = limits.uproot > 0.0f && (limits.breaking <= 0.0f || limits.uproot < limits.breaking);
    damage.kind = roots ? DamageKind::Uprooted : DamageKind::Snapped;
    damage.unit = roots ? 0 : unitAtBreast(forest, tree);
    damage.moment = limits.moment;
    damage.limit = roots ? limits.uproot : limits.breaking;
    damage.wind = meanWind(sway, slot, tree);
    limits.isDown = true;

    const glm::vec2 lean = sway.lean(slot);
    const float length = glm::length(lean);
    const glm::vec2 way = length > 0.0f ? lean / length : glm::vec2(1.0f, 0.0f);
    const glm::vec3 axis =
        turnHeading({-way.y, way.x, 0.0f}, -std::sin(tree.heading), std::cos(tree.heading));
    const double angle =
        std::atan(static_cast<double>(length / std::max(forest.measured(tree).height, 0.1f)));
    _falling.insert_or_assign(slot, Falling{FallingTree(formOf(forest, tree), damage.unit,
                                                        static_cast<double>(damage.limit), angle),
                                            damage.unit, glm::vec2(axis)});
    _broken.push_back(damage);
}

void WindDamage::forget(std::size_t slot) {
    if (slot < _limits.size())
        _limits[slot] = Limits();
    _falling.erase(slot);
}

void WindDamage::reset() {
    _limits.clear();
    _falling.clear();
    _broken.clear();
}

} // namespace osgTreeWind
