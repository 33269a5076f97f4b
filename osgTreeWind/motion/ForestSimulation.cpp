// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/motion/BranchwiseMotion.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

ForestSimulation::ForestSimulation(ForestDescription description, const std::function<void()>& placed)
    : _forest(std::move(description)), _branches(std::make_unique<BranchwiseMotion>(_forest, placed)),
      _leaves(_forest), _wind(_forest.description.wind) {}

ForestSimulation::~ForestSimulation() = default;

void ForestSimulation::reset() {
    _branches->reset();
    _leaves.reset();
    _time.reset();
}

void ForestSimulation::setWind(WindFieldPtr wind) {
    const std::lock_guard<std::mutex> lock(_windMutex);
    _wind.swap(wind); // the old field goes when the parameter does, after the lock
}

WindFieldPtr ForestSimulation::wind() const {
    const std::lock_guard<std::mutex> lock(_windMutex);
    return _wind;
}

std::optional<float> ForestSimulation::beginStep(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, maxStep) : 0.0;
    _time = time;
    _branches->sampleWind(wind().get(), time); // where no step is taken, for the next one to start from
    if (elapsed <= 0.0)
        return {};
    return static_cast<float>(elapsed);
}

bool ForestSimulation::advance(double time) {
    const std::optional<float> elapsed = beginStep(time);
    if (!elapsed)
        return false;
    _branches->step(time, *elapsed);
    _leaves.step(time);
    return true;
}

TreeMotion ForestSimulation::motion(std::size_t tree) const {
    TreeMotion motion = _branches->motionOf(_forest.trees[tree]);
    motion.leaves = _leaves.statesOf(_forest.trees[tree]);
    return motion;
}

} // namespace osgTreeWind
