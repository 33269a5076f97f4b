// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/StormTree.h>

#include <examples/osgtreewind/storm/OpenCountry.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/motion/damage/BreakableJoint.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/sway/FreeSwayTree.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace osgTreeWind {

namespace {

constexpr double longestSampleStep = 0.1; // seconds from one sample of the wind to the next

LayeredWind windOf(const PlacedForest& forest, const Storm& storm) {
    const CanopyTree tree(forest, forest.trees.front());
    const float height = std::max(tree.height, 0.1f);
    const auto wind = std::make_shared<Wind>(
        openCountryWind(static_cast<double>(height), glm::vec3(storm.speed, 0.0f, 0.0f), storm.seed));
    if (!(storm.spacing > 0.0))
        return LayeredWind(wind);
    const auto spacing = static_cast<float>(storm.spacing);
    auto stand = makeUniformCanopyMap({tree}, height, tree.frontalArea / (spacing * spacing));
    stand->setReference(height);
    return LayeredWind(wind, glm::dmat4(1.0), stand, storm.seed);
}

} // namespace

StormTree::StormTree(const Species& species, const TreePlacement& given, const Storm& storm)
    : _forest(makeSingleTreeForest(species, given)),
      _motion({makeModalTree(_forest, _forest.trees.front())}, 1.0f, {}, true), _wind(windOf(_forest, storm)),
      _load(makeModalTree(_forest, _forest.trees.front()).form) {
    const PlacedTree& tree = _forest.trees.front();
    const TreeModel& model = _forest.modelOf(tree);
    const std::vector<BranchUnit>& units = model.skeleton.units;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0 && units[i].base.z <= 0.5f * model.skeleton.height())
            _middle = i;
    const double diameter = breastDiameter(model, tree.scale);
    const float modulus = makeUnitLoads(model, tree.scale, species, tree.leaves).front().modulus;
    _strain = strainPerMoment(static_cast<double>(modulus), diameter);
    if (_wind.canopy())
        _motion.setNeighbourEffect(0, _wind.canopy()->neighbourEffectAt(glm::vec2(0.0f)));
    _motion.sampleWind(&_wind, 0.0);
}

void StormTree::advance(double time, const std::function<void()>& stepped) {
    const double from = _time;
    const int steps = std::max(static_cast<int>(std::ceil((time - from) / longestSampleStep - 1e-6)), 1);
    for (int i = 1; i <= steps; ++i) {
        const double next = from + (time - from) * i / steps;
        _motion.step(&_wind, next, static_cast<float>(next - _time));
        _time = next;
        stepped();
    }
}

double StormTree::largestMoment(double time) {
    const BreakableJoint foot{0, static_cast<float>(_load.stiffness()), 0.0f};
    double largest = 0.0;
    advance(time, [&] { largest = std::max(largest, foot.moment(_motion, 0, _motion.poseVector(0))); });
    return largest;
}

glm::vec2 StormTree::tipOf(const std::vector<UnitPose>& poses) const {
    const PlacedTree& tree = _forest.trees.front();
    const glm::vec3 top = tree.scale.axes * _forest.modelOf(tree).skeleton.units[_load.topUnit()].tip;
    return glm::vec2(poses[_load.topUnit()].apply(top) - top);
}

StormState StormTree::advance(double time) {
    advance(time, [] {});
    const ModalMotion::PoseVector vector = _motion.poseVector(0);
    std::transform(vector.begin(), vector.end(), _poses.begin(), _poses.begin(), std::plus<double>());
    ++_states;
    const std::vector<UnitPose> poses = posesOf(vector);
    StormState now;
    now.moment = _load.moment(_motion.unitAngles(0, 0, vector));
    now.push = now.moment - _load.weightMoment(poses);
    now.strain = now.moment * _strain;
    const glm::vec3 up(0.0f, 0.0f, 1.0f);
    now.tilt = glm::vec2(poses[_middle].rotation * up - up);
    now.tip = tipOf(poses);
    const PlacedTree& tree = _forest.trees.front();
    const float height = tree.scale.axes.z * _forest.modelOf(tree).skeleton.height();
    now.wind = glm::vec2(_wind.velocity(WindPlace(0.0f, 0.0f, height), time));
    return now;
}

double StormTree::weightFactor() const {
    ModalMotion::PoseVector vector;
    for (std::size_t i = 0; i < vector.size(); ++i)
        vector[i] = static_cast<float>(_poses[i] / static_cast<double>(_states));
    const float lean = glm::length(tipOf(posesOf(vector)));
    const std::vector<ModalModel::Mode>& modes = _motion.model(0).modes;
    for (std::size_t k = 0; k < modes.size(); ++k) // a static amplitude is inverse to the stiffness left
        vector[k] *= Laws().weightLeaves(modes[k].weightShare);
    const float weightless = glm::length(tipOf(posesOf(vector)));
    return weightless > 0.0f ? static_cast<double>(lean / weightless) : 1.0;
}

CriticalSpeeds criticalSpeedsOf(const Species& species, const TreePlacement& tree, const Storm& storm) {
    constexpr std::uint32_t hours = 3;
    constexpr double settling = 60.0, hour = 3600.0; // seconds
    const auto largest = [&](double speed) {
        double mean = 0.0;
        for (std::uint32_t i = 0; i < hours; ++i) {
            StormTree stormTree(species, tree, {speed, storm.spacing, storm.seed + i});
            stormTree.advance(settling);
            mean += stormTree.largestMoment(settling + hour) / hours;
        }
        return mean;
    };
    return findCriticalSpeeds(largest, StormTree(species, tree, storm).strength());
}

} // namespace osgTreeWind
