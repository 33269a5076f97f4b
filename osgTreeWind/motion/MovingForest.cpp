// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/MovingForest.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/motion/damage/FootLoad.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t shedUpdatesPerStep = 16; // trees
constexpr std::size_t largeForest = 256;       // trees; below it, threads cost more than they save
constexpr double maxWindInterval = 0.1 + 1e-6; // seconds between samples of the wind

PlacedForest placeTrees(ForestDescription&& description, const SimulationOptions& options) {
    // Branchwise laws report progress themselves, after their own work on each tree.
    const bool reports = description.law == MotionLaw::Modal;
    return PlacedForest(std::move(description), reports ? options.onTreePlaced : std::function<void()>(),
                        options.executor);
}

Executor executorFor(const Executor& given, std::size_t trees) {
    return !given && trees >= largeForest ? ThreadPool::executor() : given;
}

std::unique_ptr<WindDamage> makeDamage(const ForestDescription& description) {
    const bool isOn = description.damage && description.law == MotionLaw::Modal;
    return isOn ? std::make_unique<WindDamage>() : nullptr;
}

Diagnostics unknownTree() {
    return {keyProblem("tree", "no tree has this id; it may have been removed")};
}

Diagnostics lawWithoutEdits() {
    return {keyProblem("law", "only the law modal lets trees and species be added, removed or changed")};
}

} // namespace

MovingForest::MovingForest(ForestDescription description, const SimulationOptions& options,
                           std::shared_ptr<WindSlot> wind)
    : _placed(placeTrees(std::move(description), options)), _hostExecutor(options.executor),
      _level(options.distant ? ModalLevel::Far : ModalLevel::Near), _withLeaves(options.leaves),
      _damage(makeDamage(this->description())),
      _wind(wind ? std::move(wind) : std::make_shared<WindSlot>(this->description().wind)),
      _windCache(this->description().canopy) {
    if (this->description().law != MotionLaw::Modal) {
        _branches = std::make_unique<BranchwiseMotion>(_placed, _withLeaves, options.onTreePlaced);
        return;
    }
    std::vector<ModalTree> swaying;
    swaying.reserve(trees().size());
    for (const PlacedTree& tree : trees())
        swaying.push_back(modalTree(tree));
    _modal = std::make_unique<ModalMotion>(swaying, this->description().gain,
                                           executorFor(_hostExecutor, trees().size()));
}

MovingForest::MovingForest(const MovingForest& other)
    : _placed(other._placed), _hostExecutor(other._hostExecutor), _level(other._level),
      _withLeaves(other._withLeaves), _damage(makeDamage(description())),
      _wind(std::make_shared<WindSlot>(*other._wind->get())), _windCache(other.canopy()),
      _nextLeafUpdate(other._nextLeafUpdate) {
    if (other._modal) {
        _modal = std::make_unique<ModalMotion>(*other._modal);
        _modal->reset();
    } else {
        _branches = std::make_unique<BranchwiseMotion>(_placed, _withLeaves);
    }
    restoreLeaves();
}

ForestDescription MovingForest::currentDescription() const {
    ForestDescription now = _placed.currentDescription();
    now.wind = *_wind->get();
    now.canopy = canopy();
    return now;
}

std::vector<TreeId> MovingForest::ids() const {
    std::vector<TreeId> ids;
    ids.reserve(trees().size());
    for (std::size_t slot = 0; slot < trees().size(); ++slot)
        if (trees()[slot].alive)
            ids.push_back(_placed.idOf(slot));
    return ids;
}

Result<std::size_t> MovingForest::addSpecies(Species species) {
    if (!_modal)
        return lawWithoutEdits();
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
    return _placed.addSpecies(std::move(species), _hostExecutor);
}

Result<TreeId> MovingForest::addTree(const TreePlacement& placement) {
    if (!_modal)
        return lawWithoutEdits();
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const PlacedTree tree = _placed.makePlacedTree(placement);
    const std::size_t slot = _placed.freeSlot();
    _modal->add(slot, modalTree(tree));
    _placed.put(slot, tree, placement.name);
    treeChanged(slot);
    return _placed.idOf(slot);
}

Diagnostics MovingForest::removeTree(TreeId tree) {
    if (_placed.holds(tree))
        _placed.removePermanently(slotOfTree(tree));
    return unloadTiledTree(tree);
}

Diagnostics MovingForest::unloadTiledTree(TreeId tree) {
    if (!_placed.holds(tree))
        return unknownTree();
    if (!_modal)
        return lawWithoutEdits();
    const std::size_t slot = slotOfTree(tree);
    _modal->remove(slot);
    _values.erase(slot);
    _placed.remove(slot);
    treeChanged(slot);
    return {};
}

Diagnostics MovingForest::changeTree(TreeId tree, const TreePlacement& placement) {
    if (!_modal)
        return lawWithoutEdits();
    if (!_placed.holds(tree))
        return unknownTree();
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const std::size_t slot = slotOfTree(tree);
    PlacedTree other = _placed.makePlacedTree(placement, &trees()[slot]);
    _modal->replace(slot, modalTree(other));
    _placed.removePermanently(slot);
    other.tiled = false;
    _placed.put(slot, other, placement.name);
    treeChanged(slot);
    return {};
}

void MovingForest::spinUp(const std::vector<TreeId>& trees, float seconds) {
    if (!_modal || !_time || trees.empty())
        return;
    std::vector<std::size_t> slots;
    for (const TreeId tree : trees)
        if (_placed.holds(tree))
            slots.push_back(slotOfTree(tree));
    _modal->spinUp(slots, updateWind().get(), *_time, seconds);
}

Diagnostics MovingForest::setCanopy(const CanopySettings& canopy) {
    Diagnostics problems;
    checkKeys(canopy, "wind", problems);
    if (problems.empty())
        _windCache.setCanopy(canopy);
    return problems;
}

/// Drops what is known of the tree that was in a slot.
void MovingForest::treeChanged(std::size_t slot) {
    _windCache.treeChanged(slot);
    if (!_damage)
        return;
    _damage->clearSlot(slot);
    _modal->clearFall(slot);
}

Diagnostics MovingForest::setSeason(float season) {
    if (!std::isfinite(season))
        return {keyProblem("season", "expected a finite number")};
    _placed.setSeason(season);
    if (_damage)
        _damage->reapplyShedding(_placed);
    updateAllLeaves();
    _windCache.allTreesChanged();
    return {};
}

/// The leaf shares of all trees have changed: updates the loads under `modal`, and keeps the motion.
void MovingForest::updateAllLeaves() {
    if (!_modal)
        return;
    _nextLeafUpdate = 0;
    updateNextLeaves();
}

void MovingForest::updateNextLeaves() {
    std::vector<std::size_t> slots;
    std::vector<ModalTree> wanted;
    for (; _nextLeafUpdate < trees().size() && slots.size() < leafUpdatesPerStep; ++_nextLeafUpdate)
        if (trees()[_nextLeafUpdate].alive) {
            slots.push_back(_nextLeafUpdate);
            wanted.push_back(modalTree(trees()[_nextLeafUpdate]));
        }
    const std::size_t ready = _modal->makeArchetypesFor(wanted, newArchetypesPerStep);
    for (std::size_t i = 0; i < ready; ++i)
        _modal->replace(slots[i], wanted[i]);
    if (ready < slots.size())
        _nextLeafUpdate = slots[ready];
}

/// Restores the leaves that the wind has shed.
void MovingForest::restoreLeaves() {
    if (!_damage)
        return;
    _damage->reset();
    _placed.setSeason(_placed.season());
    updateAllLeaves();
}

void MovingForest::setExecutor(Executor executor) {
    _hostExecutor = std::move(executor);
    if (_modal)
        _modal->setExecutor(executorFor(_hostExecutor, trees().size()));
}

void MovingForest::reset() {
    if (_modal)
        _modal->reset();
    else
        _branches->reset();
    _windCache.reset();
    restoreLeaves();
    _time.reset();
}

/// Sets the time. @return seconds since the last time; zero or less if the state must not change; empty if
/// the time is the same or not finite.
std::optional<float> MovingForest::advanceTime(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, ForestSimulation::maxStep) : 0.0;
    _time = time;
    return static_cast<float>(elapsed);
}

/// The wind of the present time. Passes a changed canopy on to the trees.
WindFieldPtr MovingForest::updateWind() {
    _lastField = _windCache.fieldAtTrees(_wind->get(), _placed, *_time);
    if (_modal && _windCache.flow() != _flow) {
        _flow = _windCache.flow();
        for (std::size_t slot = 0; slot < trees().size(); ++slot)
            if (_modal->holds(slot))
                _modal->setNeighbourEffect(slot,
                                           _flow ? _flow->neighbourEffectAt(glm::vec2(trees()[slot].position))
                                                 : NeighbourEffect());
    }
    return _lastField;
}

void MovingForest::sampleWind(const WindField* wind) {
    if (_modal)
        _modal->sampleWind(wind, *_time);
    else
        _branches->sampleWind(wind, *_time);
}

void MovingForest::step(const WindField* wind, float seconds) {
    if (!_modal)
        return _branches->step(wind, *_time);
    if (_nextLeafUpdate < trees().size())
        updateNextLeaves();
    const auto elapsed = static_cast<double>(seconds);
    const int parts = static_cast<int>(std::ceil(elapsed / maxWindInterval));
    for (int part = parts - 1; part >= 0; --part)
        _modal->step(wind, *_time - elapsed * part / parts, static_cast<float>(elapsed / parts));
}

bool MovingForest::beginStep(double time) {
    const std::optional<float> elapsed = advanceTime(time);
    if (elapsed)
        sampleWind(updateWind().get());
    return elapsed.value_or(0.0f) > 0.0f;
}

bool MovingForest::advance(double time) {
    if (_damage)
        _damage->skipStep();
    const std::optional<float> elapsed = advanceTime(time);
    if (!elapsed)
        return false;
    const WindFieldPtr wind = updateWind();
    if (!(*elapsed > 0.0f)) {
        sampleWind(wind.get()); // start of the next step
        return false;
    }
    step(wind.get(), *elapsed);
    if (_damage)
        breakTrees(*elapsed);
    return true;
}

void MovingForest::breakTrees(float seconds) {
    _damage->update(_placed, *_modal, seconds, executorFor(_hostExecutor, trees().size()));
    for (const std::size_t slot : _damage->takeBaredTrees(_placed, shedUpdatesPerStep))
        _modal->replace(slot, modalTree(trees()[slot]));
}

const std::vector<TreeDamage>& MovingForest::damage() const {
    static const std::vector<TreeDamage> none;
    return _damage ? _damage->broken() : none;
}

bool MovingForest::isStanding(TreeId tree) const {
    if (!_placed.holds(tree))
        return false;
    const TreeFall* fall = _modal ? _modal->fall(slotOfTree(tree)) : nullptr;
    return !(fall && fall->isDown);
}

TreeMotion MovingForest::motion(std::size_t slot) const {
    if (!_modal)
        return _branches->motion(slot);
    if (!_modal->holds(slot))
        return {};
    std::unique_lock<std::mutex> lock(_valuesMutex);
    UnitValues& values = _values[slot];
    lock.unlock();
    return motion(slot, values);
}

TreeMotion MovingForest::motion(std::size_t slot, UnitValues& values) const {
    if (!_modal)
        return _branches->motion(slot);
    return ModalPoses{_placed, *_modal, _time.value_or(0.0), _withLeaves}.motion(slot, values);
}

UnitMotion MovingForest::unitMotion(std::size_t slot, std::size_t unit) const {
    if (!_modal)
        return _branches->unitMotion(slot, unit);
    return ModalPoses{_placed, *_modal, _time.value_or(0.0), _withLeaves}.unitMotion(slot, unit);
}

std::optional<TreeSway> MovingForest::sway(TreeId tree) const {
    if (!_modal || !isStanding(tree))
        return {};
    const PlacedTree& placed = trees()[slotOfTree(tree)];
    TreeSway sway = swayOf(_placed, slotOfTree(tree), *_modal);
    const glm::vec3 top = placed.position + glm::vec3(0.0f, 0.0f, _placed.sizeOf(placed).height);
    if (_lastField && _time)
        sway.windAtTop = _lastField->velocity(WindPlace(top, placed.position.z), *_time);
    return sway;
}

std::vector<BranchLoad> MovingForest::branchLoads(TreeId tree) const {
    if (!_modal || !isStanding(tree))
        return {};
    return branchLoadsOf(_placed, slotOfTree(tree), *_modal);
}

} // namespace osgTreeWind
