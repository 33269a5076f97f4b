// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/motion/ForestMemory.h>
#include <osgTreeWind/motion/WindAmongTrees.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/damage/WindDamage.h>
#include <osgTreeWind/motion/modal/ModalForest.h>
#include <osgTreeWind/wind/GivenWind.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t baredAtOnce = 16;  // trees
constexpr std::size_t largeForest = 256; // trees; below it threads cost more than they give

std::unique_ptr<PlacedForest> placed(ForestDescription&& description, const SimulationOptions& options) {
    const bool last = description.law == MotionLaw::Modal; // laws of a branch have work to do on each tree
    return std::make_unique<PlacedForest>(std::move(description),
                                          last ? options.placed : std::function<void()>(), options.executor);
}

Executor executorFor(const Executor& given, std::size_t trees) {
    return !given && trees >= largeForest ? ThreadPool::executor() : given;
}

std::unique_ptr<Motion> motionOf(const PlacedForest& forest, const SimulationOptions& options) {
    if (forest.description().law != MotionLaw::Modal)
        return std::make_unique<BranchwiseMotion>(forest, options.leaves, options.placed);
    const ModalLevel level = options.distant ? ModalLevel::Far : ModalLevel::Near;
    return std::make_unique<ModalForest>(forest, level, options.leaves,
                                         executorFor(options.executor, forest.trees.size()));
}

std::unique_ptr<WindDamage> damageOf(const ForestDescription& description) {
    const bool some = description.damage && description.law == MotionLaw::Modal;
    return some ? std::make_unique<WindDamage>() : nullptr;
}

Diagnostics noSuchTree() {
    return {keyProblem("tree", "no tree has this id, or it is gone")};
}

/// An empty one, and a warning, where it is refused.
ForestDescription accepted(ForestDescription&& description) {
    const Diagnostics problems = check(description);
    if (problems.empty())
        return std::move(description);
    std::cerr << "osgTreeWind: the forest is left empty: " + linesOf(problems) + '\n';
    return {};
}

} // namespace

ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options)
    : ForestSimulation(accepted(std::move(description)), options, nullptr) {}

/// @param wind null: a place of its own, with the description's.
ForestSimulation::ForestSimulation(ForestDescription description, const SimulationOptions& options,
                                   std::shared_ptr<GivenWind> wind)
    : _forest(placed(std::move(description), options)), _lent(options.executor),
      _motion(motionOf(*_forest, options)),
      _wind(wind ? std::move(wind) : std::make_shared<GivenWind>(this->description().wind)),
      _amongTrees(std::make_unique<WindAmongTrees>()), _damage(damageOf(this->description())) {}

ForestSimulation::ForestSimulation(const ForestSimulation& other)
    : _forest(std::make_unique<PlacedForest>(*other._forest)), _lent(other._lent),
      _motion(other._motion->restarted(*_forest)), _wind(std::make_shared<GivenWind>(*other._wind->get())),
      _amongTrees(std::make_unique<WindAmongTrees>()), _damage(damageOf(description())) {
    regrow();
}

ForestSimulation::~ForestSimulation() = default;

std::shared_ptr<ForestSimulation> ForestSimulation::restarted() const {
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
    if (Diagnostics problems = _motion->fixed(); !problems.empty())
        return problems;
    if (Diagnostics problems = check(species); !problems.empty())
        return problems;
    for (const Species& other : description().species)
        if (other.name == species.name && !species.name.empty())
            return keyProblem("name", "the name " + inQuotes(species.name) + " is taken already");
    ForestDescription alone;
    alone.species = {species};
    const ForestMemory memory = forestMemory(alone);
    if (const std::string problem =
            problemOfMemory("the shapes of this species", memory.simulation + memory.nodes);
        !problem.empty())
        return keyProblem({}, problem);
    return _forest->addSpecies(std::move(species), _lent);
}

Result<TreeId> ForestSimulation::addTree(const TreePlacement& placement) {
    if (Diagnostics problems = _motion->fixed(); !problems.empty())
        return problems;
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const PlacedTree tree = _forest->fitted(placement);
    const std::size_t slot = _motion->add(tree);
    _forest->put(slot, tree, placement.name);
    treeChanged(slot);
    return idOf(slot);
}

Diagnostics ForestSimulation::removeTree(TreeId tree) {
    if (holds(tree))
        _forest->strike(slotOf(tree));
    return unloadTree(tree);
}

Diagnostics ForestSimulation::unloadTree(TreeId tree) {
    if (!holds(tree))
        return noSuchTree();
    if (Diagnostics problems = _motion->fixed(); !problems.empty())
        return problems;
    _motion->remove(slotOf(tree));
    _forest->remove(slotOf(tree));
    treeChanged(slotOfTree(tree));
    return {};
}

Diagnostics ForestSimulation::changeTree(TreeId tree, const TreePlacement& placement) {
    if (Diagnostics problems = _motion->fixed(); !problems.empty())
        return problems;
    if (!holds(tree))
        return noSuchTree();
    if (Diagnostics problems = check(placement, description()); !problems.empty())
        return problems;
    const std::size_t slot = slotOf(tree);
    PlacedTree other = _forest->fitted(placement, &_forest->trees[slot]);
    _motion->replace(slot, other);
    _forest->strike(slot);
    other.tiled = false;
    _forest->put(slot, other, placement.name);
    treeChanged(slot);
    return {};
}

void ForestSimulation::runUp(const std::vector<TreeId>& trees) {
    if (!_time || trees.empty())
        return;
    std::vector<std::size_t> slots;
    for (const TreeId tree : trees)
        if (holds(tree))
            slots.push_back(slotOf(tree));
    _motion->runUp(slots, windHere().get(), *_time, runUpTime);
}

/// Another tree is there, or none, which has not come down.
void ForestSimulation::treeChanged(std::size_t slot) {
    _amongTrees->treeChanged(slot);
    if (!_damage)
        return;
    _damage->forget(slot);
    _motion->putUpright(slot);
}

/// The leaves that the wind has shed.
void ForestSimulation::regrow() {
    if (!_damage)
        return;
    _damage->reset();
    _forest->setSeason(season());
    _motion->followSeason();
}

Diagnostics ForestSimulation::setSeason(float season) {
    if (!std::isfinite(season))
        return {keyProblem("season", "expected a finite number")};
    _forest->setSeason(season);
    if (_damage)
        _damage->shedAgain(*_forest);
    _motion->followSeason();
    _amongTrees->allTreesChanged();
    return {};
}

std::optional<TreeId> ForestSimulation::findTree(const std::string& name) const {
    const std::optional<std::uint32_t> slot = _forest->names.find(name);
    return slot ? std::optional(idOf(*slot)) : std::nullopt;
}

std::string ForestSimulation::nameOf(TreeId tree) const {
    return holds(tree) ? _forest->names.of(static_cast<std::uint32_t>(slotOf(tree))) : std::string();
}

void ForestSimulation::setWind(Wind wind) {
    _wind->set(std::move(wind));
}

Wind ForestSimulation::wind() const {
    return *_wind->get();
}

void ForestSimulation::setExecutor(Executor executor) {
    _lent = std::move(executor);
    _motion->setExecutor(executorFor(_lent, slotCount()));
}

Executor ForestSimulation::executor() const {
    return _lent ? _lent : ThreadPool::executor();
}

void ForestSimulation::reset() {
    _motion->reset();
    _amongTrees->reset();
    regrow();
    _time.reset();
}

/// Seconds from the last time to this one, which becomes the last; none or less: the state is to be kept.
/// Nothing where it is no other time.
std::optional<float> ForestSimulation::elapsedAt(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, maxStep) : 0.0;
    _time = time;
    return static_cast<float>(elapsed);
}

WindFieldPtr ForestSimulation::windHere() {
    WindFieldPtr wind = _amongTrees->from(*_wind, *_forest, *_time);
    if (_amongTrees->company() && _amongTrees->company() != _stand) {
        _stand = _amongTrees->company();
        _motion->standIn(*_stand);
    }
    return wind;
}

bool ForestSimulation::beginStep(double time) {
    const std::optional<float> elapsed = elapsedAt(time);
    if (elapsed)
        _motion->meet(windHere().get(), time);
    return elapsed.value_or(0.0f) > 0.0f;
}

bool ForestSimulation::advance(double time) {
    if (_damage)
        _damage->pause();
    const std::optional<float> elapsed = elapsedAt(time);
    if (!elapsed)
        return false;
    const WindFieldPtr wind = windHere();
    if (!(*elapsed > 0.0f)) {
        _motion->meet(wind.get(), time); // for the next step to start from
        return false;
    }
    _motion->step(wind.get(), time, *elapsed);
    if (_damage) {
        _damage->follow(*_forest, *_motion->modal(), *elapsed, executorFor(_lent, slotCount()));
        _motion->followLeaves(_damage->bared(*_forest, baredAtOnce));
    }
    return true;
}

const std::vector<TreeDamage>& ForestSimulation::damage() const {
    static const std::vector<TreeDamage> none;
    return _damage ? _damage->broken() : none;
}

bool ForestSimulation::stands(TreeId tree) const {
    const TreeFall* fall = holds(tree) ? _motion->fall(slotOf(tree)) : nullptr;
    return holds(tree) && !(fall && fall->isDown);
}

TreeMotion ForestSimulation::motion(std::size_t slot) const {
    return _motion->motion(slot);
}

TreeMotion ForestSimulation::motion(std::size_t slot, UnitValues& values) const {
    return _motion->motion(slot, values);
}

UnitMotion ForestSimulation::unitMotion(std::size_t slot, std::size_t unit) const {
    return _motion->unitMotion(slot, unit);
}

} // namespace osgTreeWind
