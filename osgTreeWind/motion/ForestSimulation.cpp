// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/motion/CanopyWind.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/damage/FootLoad.h>
#include <osgTreeWind/motion/damage/WindDamage.h>
#include <osgTreeWind/motion/modal/ModalForest.h>
#include <osgTreeWind/wind/HostWind.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t shedUpdatesPerStep = 16; // trees
constexpr std::size_t largeForest = 256;       // trees; below it, threads cost more than they save

std::unique_ptr<PlacedForest> placeTrees(ForestDescription&& description, const SimulationOptions& options) {
    // Branchwise laws report progress themselves, after their own work on each tree.
    const bool reports = description.law == MotionLaw::Modal;
    return std::make_unique<PlacedForest>(
        std::move(description), reports ? options.onTreePlaced : std::function<void()>(), options.executor);
}

Executor executorFor(const Executor& given, std::size_t trees) {
    return !given && trees >= largeForest ? ThreadPool::executor() : given;
}

std::unique_ptr<Motion> makeMotion(const PlacedForest& forest, const SimulationOptions& options) {
    if (forest.description().law != MotionLaw::Modal)
        return std::make_unique<BranchwiseMotion>(forest, options.leaves, options.onTreePlaced);
    const ModalLevel level = options.distant ? ModalLevel::Far : ModalLevel::Near;
    return std::make_unique<ModalForest>(forest, level, options.leaves,
                                         executorFor(options.executor, forest.trees.size()));
}

std::unique_ptr<WindDamage> makeDamage(const ForestDescription& description) {
    const bool isOn = description.damage && description.law == MotionLaw::Modal;
    return isOn ? std::make_unique<WindDamage>() : nullptr;
}

Diagnostics unknownTree() {
    return {keyProblem("tree", "no tree has this id; it may have been removed")};
}

/// The description; empty, with a message to stderr, if it is invalid.
ForestDescription emptyIfInvalid(ForestDescription&& description) {
    const Diagnostics problems = check(description);
    if (problems.empty())
        return std::move(description);
    std::cerr << "osgTreeWind: the forest is left empty: " + toString(problems) + '\n';
    return {};
}

} // namespace

ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options)
    : ForestSimulation(emptyIfInvalid(std::move(description)), options, nullptr) {}

/// @param wind null: a new one with the description's wind.
ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options,
                                   std::shared_ptr<HostWind> wind)
    : _forest(placeTrees(std::move(description), options)), _hostExecutor(options.executor),
      _motion(makeMotion(*_forest, options)),
      _wind(wind ? std::move(wind) : std::make_shared<HostWind>(this->description().wind)),
      _canopyWind(std::make_unique<CanopyWind>()), _damage(makeDamage(this->description())) {}

ForestSimulation::ForestSimulation(const ForestSimulation& other)
    : _forest(std::make_unique<PlacedForest>(*other._forest)), _hostExecutor(other._hostExecutor),
      _motion(other._motion->cloneAtRest(*_forest)), _wind(std::make_shared<HostWind>(*other._wind->get())),
      _canopyWind(std::make_unique<CanopyWind>()), _damage(makeDamage(description())) {
    restoreLeaves();
}

ForestSimulation::~ForestSimulation() = default;

Result<std::shared_ptr<ForestSimulation>> ForestSimulation::create(ForestDescription description,
                                                                   const SimulationOptions& options) {
    return guardedResult([&]() -> Result<std::shared_ptr<ForestSimulation>> {
        if (Diagnostics problems = check(description); !problems.empty())
            return problems;
        if (const std::string problem = problemOfMemory(description, false); !problem.empty())
            return keyProblem({}, problem);
        return std::shared_ptr<ForestSimulation>(
            new ForestSimulation(std::move(description), options, nullptr));
    });
}

std::shared_ptr<ForestSimulation> ForestSimulation::cloneAtRest() const {
    return std::shared_ptr<ForestSimulation>(new ForestSimulation(*this));
}

const ForestDescription& ForestSimulation::description() const {
    return _forest->description();
}

ForestDescription ForestSimulation::describe() const {
    ForestDescription now = _forest->describe();
    now.wind = *_wind->get();
    return now;
}

std::size_t ForestSimulation::slotCount() const {
    return _forest->trees.size();
}

std::size_t ForestSimulation::modelCount() const {
    return _forest->models().size();
}

const Skeleton& ForestSimulation::skeleton(std::size_t model) const {
    return _forest->models()[model]->skeleton;
}

std::size_t ForestSimulation::modelOf(std::size_t slot) const {
    return _forest->trees[slot].model;
}

TreeScale ForestSimulation::scaleOf(std::size_t slot) const {
    return _forest->trees[slot].scale;
}

bool ForestSimulation::holds(TreeId tree) const {
    return _forest->holds(tree);
}

TreeId ForestSimulation::idOf(std::size_t slot) const {
    return _forest->idOf(slot);
}

TreePlacement ForestSimulation::placementOf(TreeId tree) const {
    return _forest->placementOf(slotOf(tree));
}

float ForestSimulation::season() const {
    return _forest->season();
}

Result<std::size_t> ForestSimulation::addSpecies(Species species) {
    if (Diagnostics problems = _motion->editProblems(); !problems.empty())
        return problems;
    if (Diagnostics problems = check(species); !problems.empty())
        return problems;
    for (const Species& other : description().species)
        if (other.name == species.name && !species.name.empty())
            return keyProblem("name", "the name " + inQuotes(species.name) + " is taken already");
    ForestDescription alone;
    alone.species = {species};
    const MemoryEstimate memory = estimateMemory(alone);
    if (const std::string problem =
            problemOfMemory("the shapes of this species", memory.simulation + memory.nodes);
        !problem.empty())
        return keyProblem({}, problem);
    return _forest->addSpecies(std::move(species), _hostExecutor);
}

Result<TreeId> ForestSimulation::addTree(const TreePlacement& placement) {
    if (Diagnostics problems = _motion->editProblems(); !problems.empty())
        return problems;
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const PlacedTree tree = _forest->makePlacedTree(placement);
    const std::size_t slot = _motion->add(tree);
    _forest->put(slot, tree, placement.name);
    treeChanged(slot);
    return idOf(slot);
}

Diagnostics ForestSimulation::removeTree(TreeId tree) {
    if (holds(tree))
        _forest->removePermanently(slotOf(tree));
    return unloadTiledTree(tree);
}

Diagnostics ForestSimulation::unloadTiledTree(TreeId tree) {
    if (!holds(tree))
        return unknownTree();
    if (Diagnostics problems = _motion->editProblems(); !problems.empty())
        return problems;
    _motion->remove(slotOf(tree));
    _forest->remove(slotOf(tree));
    treeChanged(slotOfTree(tree));
    return {};
}

Diagnostics ForestSimulation::changeTree(TreeId tree, const TreePlacement& placement) {
    if (Diagnostics problems = _motion->editProblems(); !problems.empty())
        return problems;
    if (!holds(tree))
        return unknownTree();
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const std::size_t slot = slotOf(tree);
    PlacedTree other = _forest->makePlacedTree(placement, &_forest->trees[slot]);
    _motion->replace(slot, other);
    _forest->removePermanently(slot);
    other.tiled = false;
    _forest->put(slot, other, placement.name);
    treeChanged(slot);
    return {};
}

void ForestSimulation::spinUp(const std::vector<TreeId>& trees) {
    if (!_time || trees.empty())
        return;
    std::vector<std::size_t> slots;
    for (const TreeId tree : trees)
        if (holds(tree))
            slots.push_back(slotOf(tree));
    _motion->spinUp(slots, updateWind().get(), *_time, spinUpTime);
}

/// Drops what is known of the tree that was in a slot.
void ForestSimulation::treeChanged(std::size_t slot) {
    _canopyWind->treeChanged(slot);
    if (!_damage)
        return;
    _damage->clearSlot(slot);
    _motion->clearFall(slot);
}

/// Restores the leaves that the wind has shed.
void ForestSimulation::restoreLeaves() {
    if (!_damage)
        return;
    _damage->reset();
    _forest->setSeason(season());
    _motion->updateAllLeaves();
}

Diagnostics ForestSimulation::setSeason(float season) {
    if (!std::isfinite(season))
        return {keyProblem("season", "expected a finite number")};
    _forest->setSeason(season);
    if (_damage)
        _damage->reapplyShedding(*_forest);
    _motion->updateAllLeaves();
    _canopyWind->allTreesChanged();
    return {};
}

std::optional<TreeId> ForestSimulation::findTree(const std::string& name) const {
    const std::optional<std::uint32_t> slot = _forest->names.find(name);
    return slot ? std::optional(idOf(*slot)) : std::nullopt;
}

std::string ForestSimulation::nameOf(TreeId tree) const {
    return holds(tree) ? _forest->names.of(static_cast<std::uint32_t>(slotOf(tree))) : std::string();
}

Diagnostics ForestSimulation::setWind(Wind wind) {
    return _wind->set(std::move(wind));
}

Wind ForestSimulation::wind() const {
    return *_wind->get();
}

void ForestSimulation::setExecutor(Executor executor) {
    _hostExecutor = std::move(executor);
    _motion->setExecutor(executorFor(_hostExecutor, slotCount()));
}

Executor ForestSimulation::executor() const {
    return _hostExecutor ? _hostExecutor : ThreadPool::executor();
}

void ForestSimulation::reset() {
    _motion->reset();
    _canopyWind->reset();
    restoreLeaves();
    _time.reset();
}

/// Sets the time. @return seconds since the last time; zero or less if the state must not change; empty if
/// the time is the same or not finite.
std::optional<float> ForestSimulation::advanceTime(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, maxStep) : 0.0;
    _time = time;
    return static_cast<float>(elapsed);
}

WindFieldPtr ForestSimulation::updateWind() {
    _lastField = _canopyWind->update(*_wind, *_forest, *_time);
    if (_canopyWind->flow() && _canopyWind->flow() != _canopyFlow) {
        _canopyFlow = _canopyWind->flow();
        _motion->setCanopyFlow(*_canopyFlow);
    }
    return _lastField;
}

bool ForestSimulation::beginStep(double time) {
    const std::optional<float> elapsed = advanceTime(time);
    if (elapsed)
        _motion->sampleWind(updateWind().get(), time);
    return elapsed.value_or(0.0f) > 0.0f;
}

bool ForestSimulation::advance(double time) {
    if (_damage)
        _damage->skipStep();
    const std::optional<float> elapsed = advanceTime(time);
    if (!elapsed)
        return false;
    const WindFieldPtr wind = updateWind();
    if (!(*elapsed > 0.0f)) {
        _motion->sampleWind(wind.get(), time); // start of the next step
        return false;
    }
    _motion->step(wind.get(), time, *elapsed);
    if (_damage) {
        _damage->update(*_forest, *_motion->modal(), *elapsed, executorFor(_hostExecutor, slotCount()));
        _motion->updateLeaves(_damage->takeBaredTrees(*_forest, shedUpdatesPerStep));
    }
    return true;
}

const std::vector<TreeDamage>& ForestSimulation::damage() const {
    static const std::vector<TreeDamage> none;
    return _damage ? _damage->broken() : none;
}

bool ForestSimulation::isStanding(TreeId tree) const {
    const TreeFall* fall = holds(tree) ? _motion->fall(slotOf(tree)) : nullptr;
    return holds(tree) && !(fall && fall->isDown);
}

TreeMotion ForestSimulation::motion(std::size_t slot) const {
    return _motion->motion(slot);
}

TreeMotion ForestSimulation::motion(std::size_t slot, UnitValues& values) const {
    return _motion->motion(slot, values);
}

std::optional<TreeSway> ForestSimulation::sway(TreeId tree) const {
    const ModalMotion* modal = _motion->modal();
    if (!modal || !isStanding(tree))
        return {};
    const PlacedTree& placed = _forest->trees[slotOf(tree)];
    TreeSway sway = swayOf(*_forest, slotOf(tree), *modal);
    const glm::vec3 top = placed.position + glm::vec3(0.0f, 0.0f, _forest->sizeOf(placed).height);
    if (_lastField && _time)
        sway.windAtTop = _lastField->velocity(WindPlace(top, placed.position.z), *_time);
    return sway;
}

UnitMotion ForestSimulation::unitMotion(std::size_t slot, std::size_t unit) const {
    return _motion->unitMotion(slot, unit);
}

} // namespace osgTreeWind
