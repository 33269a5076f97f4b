// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/motion/BranchwiseMotion.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t largeForest = 256; // trees; below it threads cost more than they give

std::unique_ptr<ModalMotion> makeModal(const PlacedForest& forest, const SimulationOptions& options) {
    Executor executor = options.executor;
    if (!executor && forest.trees.size() >= largeForest)
        executor = ThreadPool::executor();
    std::vector<ModalMotion::Tree> trees;
    trees.reserve(forest.trees.size());
    for (const PlacedTree& tree : forest.trees)
        trees.push_back({{&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves},
                         tree.position,
                         tree.heading});
    return std::make_unique<ModalMotion>(trees, forest.description.gain, std::move(executor));
}

} // namespace

ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options)
    : _forest(std::move(description)), _leaves(_forest, options.leaves), _wind(_forest.description.wind) {
    if (_forest.description.law != MotionLaw::Modal) {
        _branches = std::make_unique<BranchwiseMotion>(_forest, options.placed);
        return;
    }
    _modal = makeModal(_forest, options);
    _values.resize(_forest.trees.size());
    for (std::size_t i = 0; options.placed && i < _forest.trees.size(); ++i)
        options.placed();
}

ForestSimulation::~ForestSimulation() = default;

void ForestSimulation::reset() {
    if (_modal)
        _modal->reset();
    else
        _branches->reset();
    _leaves.reset();
    _time.reset();
}

void ForestSimulation::setLevel(std::size_t tree, ModalMotion::Level level) {
    if (_modal)
        _modal->setLevel(tree, level);
}

void ForestSimulation::setWind(WindFieldPtr wind) {
    const std::lock_guard<std::mutex> lock(_windMutex);
    _wind.swap(wind); // the old field goes when the parameter does, after the lock
}

WindFieldPtr ForestSimulation::wind() const {
    const std::lock_guard<std::mutex> lock(_windMutex);
    return _wind;
}

/// Where no step is taken, for the next one to start from.
void ForestSimulation::meetWind(double time) {
    if (_modal)
        _modal->meet(wind().get(), time);
    else
        _branches->sampleWind(wind().get(), time);
}

std::optional<float> ForestSimulation::beginStep(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, maxStep) : 0.0;
    _time = time;
    if (elapsed <= 0.0 || _branches)
        meetWind(time);
    if (elapsed <= 0.0)
        return {};
    return static_cast<float>(elapsed);
}

bool ForestSimulation::advance(double time) {
    const std::optional<float> elapsed = beginStep(time);
    if (!elapsed)
        return false;
    if (_modal)
        _modal->step(wind().get(), time, *elapsed);
    else
        _branches->step(time, *elapsed);
    _leaves.step(time);
    return true;
}

TreeMotion ForestSimulation::motion(std::size_t tree) const {
    if (!_modal)
        return branchwiseMotion(tree);
    if (!_values[tree])
        _values[tree] = std::make_unique<UnitValues>();
    return motion(tree, *_values[tree]);
}

TreeMotion ForestSimulation::motion(std::size_t index, UnitValues& values) const {
    if (!_modal)
        return branchwiseMotion(index);
    const PlacedTree& tree = _forest.trees[index];
    const Skeleton& skeleton = _forest.modelOf(tree).skeleton;
    const std::size_t units = skeleton.units.size();
    values.resize(units);
    _modal->angles(index, values.angles.data());
    _modal->winds(index, values.winds.data());
    for (std::size_t i = 0; i < units; ++i)
        values.states[i] = glm::vec4(values.angles[i], 0.0f, 0.0f);
    swingPoses(skeleton, tree.scale, values.angles.data(), values.rotations.data(), values.poses.data());
    return {{values.poses.data(), units},
            {values.rotations.data(), units},
            {values.states.data(), units},
            {values.winds.data(), units},
            _leaves.statesOf(tree)};
}

TreeMotion ForestSimulation::branchwiseMotion(std::size_t tree) const {
    TreeMotion motion = _branches->motionOf(_forest.trees[tree]);
    motion.leaves = _leaves.statesOf(_forest.trees[tree]);
    return motion;
}

} // namespace osgTreeWind
