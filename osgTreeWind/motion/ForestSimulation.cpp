// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t largeForest = 256;   // trees; below it threads cost more than they give
constexpr double longestPart = 0.1 + 1e-6; // seconds from one sample of the wind to the next

PlacedForest placed(ForestDescription&& description, const SimulationOptions& options) {
    const bool last = description.law == MotionLaw::Modal; // laws of a branch have work to do on each tree
    return PlacedForest(std::move(description), last ? options.placed : std::function<void()>());
}

Executor executorFor(const SimulationOptions& options, std::size_t trees) {
    return !options.executor && trees >= largeForest ? ThreadPool::executor() : options.executor;
}

} // namespace

ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options)
    : _forest(placed(std::move(description), options)), _level(options.level), _withLeaves(options.leaves),
      _leaves(_forest, options.leaves && _forest.description().law != MotionLaw::Modal),
      _wind(_forest.description().wind) {
    if (this->description().law != MotionLaw::Modal) {
        _branches = std::make_unique<BranchwiseMotion>(_forest, options.placed);
        return;
    }
    std::vector<ModalMotion::Tree> trees;
    trees.reserve(_forest.trees.size());
    for (const PlacedTree& tree : _forest.trees)
        trees.push_back(swaying(tree));
    _modal =
        std::make_unique<ModalMotion>(trees, this->description().gain, executorFor(options, trees.size()));
}

ForestSimulation::ForestSimulation(const ForestSimulation& other)
    : _forest(other._forest), _level(other._level), _withLeaves(other._withLeaves),
      _leaves(_forest, !other._leaves.states().empty()), _wind(other.wind()) {
    if (other._modal)
        _modal = other._modal->restarted();
    else
        _branches = std::make_unique<BranchwiseMotion>(_forest);
}

ForestSimulation::~ForestSimulation() = default;

std::shared_ptr<ForestSimulation> ForestSimulation::restarted() const {
    return std::shared_ptr<ForestSimulation>(new ForestSimulation(*this));
}

ForestDescription ForestSimulation::describe() const {
    ForestDescription now = _forest.describe();
    now.wind = wind();
    return now;
}

ModalMotion::Tree ForestSimulation::swaying(const PlacedTree& tree) const {
    return {{&_forest.modelOf(tree), &_forest.speciesOf(tree), tree.scale, tree.leaves},
            tree.position,
            tree.heading,
            _level};
}

TreeId ForestSimulation::addTree(const TreePlacement& placement) {
    const std::optional<PlacedTree> tree = _modal ? _forest.fitted(placement) : std::nullopt;
    if (!tree)
        return noTree;
    const std::size_t slot = _modal->add(swaying(*tree));
    _forest.put(slot, *tree, placement.name);
    return idOf(slot);
}

bool ForestSimulation::removeTree(TreeId tree) {
    if (!_modal || !holds(tree))
        return false;
    _modal->remove(slotOf(tree));
    _forest.remove(slotOf(tree));
    _values.erase(slotOf(tree));
    return true;
}

bool ForestSimulation::changeTree(TreeId tree, const TreePlacement& placement) {
    if (!_modal || !holds(tree))
        return false;
    const std::size_t slot = slotOf(tree);
    const std::optional<PlacedTree> other = _forest.fitted(placement, &trees()[slot]);
    if (!other)
        return false;
    _modal->replace(slot, swaying(*other));
    _forest.put(slot, *other, placement.name);
    return true;
}

void ForestSimulation::setSeason(float season) {
    _forest.setSeason(season);
    if (_branches)
        return _branches->refit();
    for (std::size_t slot = 0; slot < trees().size(); ++slot)
        if (trees()[slot].alive)
            _modal->replace(slot, swaying(trees()[slot]));
}

std::optional<TreeId> ForestSimulation::findTree(const std::string& name) const {
    const std::optional<std::uint32_t> slot = _forest.names.find(name);
    return slot ? std::optional(idOf(*slot)) : std::nullopt;
}

std::string ForestSimulation::nameOf(TreeId tree) const {
    return holds(tree) ? _forest.names.of(static_cast<std::uint32_t>(slotOf(tree))) : std::string();
}

void ForestSimulation::reset() {
    if (_modal)
        _modal->reset();
    else
        _branches->reset();
    _leaves.reset();
    _time.reset();
}

void ForestSimulation::setLevel(std::size_t tree, ModalMotion::Level level) {
    if (_modal && _modal->holds(tree))
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

void ForestSimulation::stepModal(double time, double elapsed) {
    const WindFieldPtr wind = this->wind();
    const int parts = static_cast<int>(std::ceil(elapsed / longestPart));
    for (int part = parts - 1; part >= 0; --part)
        _modal->step(wind.get(), time - elapsed * part / parts, static_cast<float>(elapsed / parts));
}

bool ForestSimulation::advance(double time) {
    const std::optional<float> elapsed = beginStep(time);
    if (!elapsed)
        return false;
    if (_modal)
        stepModal(time, static_cast<double>(*elapsed));
    else
        _branches->step(time, *elapsed);
    _leaves.step(time);
    return true;
}

UnitValues& ForestSimulation::valuesOf(std::size_t tree) const {
    const std::lock_guard<std::mutex> lock(_valuesMutex);
    return _values[tree];
}

TreeMotion ForestSimulation::motion(std::size_t tree) const {
    if (!_modal)
        return branchwiseMotion(tree);
    if (!_modal->holds(tree))
        return {};
    return motion(tree, valuesOf(tree));
}

TreeMotion ForestSimulation::motion(std::size_t index, UnitValues& values) const {
    if (!_modal)
        return branchwiseMotion(index);
    if (!_modal->holds(index))
        return {};
    const PlacedTree& tree = _forest.trees[index];
    const Skeleton& skeleton = _forest.modelOf(tree).skeleton;
    const std::size_t units = skeleton.units.size();
    const std::vector<LeafCluster>& leaves = _forest.modelOf(tree).leaves;
    values.resize(units, _withLeaves ? leaves.size() : 0);
    _modal->angles(index, values.angles.data());
    _modal->winds(index, values.winds.data());
    for (std::size_t i = 0; i < units; ++i)
        values.states[i] = glm::vec4(values.angles[i], 0.0f, 0.0f);
    swingPoses(skeleton, tree.scale, values.angles.data(), values.rotations.data(), values.poses.data());
    if (_withLeaves)
        flutter(tree, values);
    return {{values.poses.data(), units},
            {values.rotations.data(), units},
            {values.states.data(), units},
            {values.winds.data(), units},
            {values.leaves.data(), values.leaves.size()}};
}

void ForestSimulation::flutter(const PlacedTree& tree, UnitValues& values) const {
    const std::vector<LeafCluster>& leaves = _forest.modelOf(tree).leaves;
    const LeafMotion& leaf = _forest.speciesOf(tree).leaf;
    StatelessFlutter{{leaves.data(), leaves.size()},
                     {values.winds.data(), values.winds.size()},
                     flutterPhases(_time.value_or(0.0), leaf),
                     flutterLimits(leaf),
                     ownNumber(tree.seed)}
        .run(values.leaves.data());
}

TreeMotion ForestSimulation::branchwiseMotion(std::size_t tree) const {
    TreeMotion motion = _branches->motionOf(_forest.trees[tree]);
    motion.leaves = _leaves.statesOf(_forest.trees[tree]);
    return motion;
}

} // namespace osgTreeWind
