// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <iostream>
#include <utility>

namespace osgTreeWind {

namespace {

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
    : _forest(std::make_unique<MovingForest>(emptyIfInvalid(std::move(description)), options)) {}

ForestSimulation::ForestSimulation(std::unique_ptr<MovingForest> forest) : _forest(std::move(forest)) {}

ForestSimulation::~ForestSimulation() = default;

Result<std::shared_ptr<ForestSimulation>> ForestSimulation::create(ForestDescription description,
                                                                   const SimulationOptions& options) {
    return guardedResult([&]() -> Result<std::shared_ptr<ForestSimulation>> {
        if (Diagnostics problems = check(description); !problems.empty())
            return problems;
        if (const std::string problem = problemOfMemory(description, false); !problem.empty())
            return keyProblem({}, problem);
        return std::shared_ptr<ForestSimulation>(
            new ForestSimulation(std::make_unique<MovingForest>(std::move(description), options)));
    });
}

std::shared_ptr<ForestSimulation> ForestSimulation::cloneAtRest() const {
    return std::shared_ptr<ForestSimulation>(new ForestSimulation(std::make_unique<MovingForest>(*_forest)));
}

MovingForest& movingForest(const ForestSimulation& simulation) {
    return *simulation._forest;
}

const ForestDescription& ForestSimulation::description() const {
    return _forest->description();
}

ForestDescription ForestSimulation::currentDescription() const {
    return _forest->currentDescription();
}

std::vector<TreeId> ForestSimulation::trees() const {
    return _forest->ids();
}

std::size_t ForestSimulation::modelCount() const {
    return _forest->models().size();
}

const Skeleton& ForestSimulation::skeleton(std::size_t model) const {
    return _forest->models()[model]->skeleton;
}

std::optional<std::size_t> ForestSimulation::modelOf(TreeId tree) const {
    return holds(tree) ? std::optional<std::size_t>(_forest->trees()[slotOfTree(tree)].model) : std::nullopt;
}

TreeScale ForestSimulation::scaleOf(TreeId tree) const {
    return holds(tree) ? _forest->trees()[slotOfTree(tree)].scale : TreeScale();
}

Result<std::size_t> ForestSimulation::addSpecies(Species species) {
    return _forest->addSpecies(std::move(species));
}

Result<TreeId> ForestSimulation::addTree(const TreePlacement& placement) {
    return _forest->addTree(placement);
}

Diagnostics ForestSimulation::removeTree(TreeId tree) {
    return _forest->removeTree(tree);
}

Diagnostics ForestSimulation::changeTree(TreeId tree, const TreePlacement& placement) {
    return _forest->changeTree(tree, placement);
}

void ForestSimulation::spinUp(const std::vector<TreeId>& trees) {
    _forest->spinUp(trees, spinUpTime);
}

bool ForestSimulation::holds(TreeId tree) const {
    return _forest->placed().holds(tree);
}

std::optional<TreeId> ForestSimulation::findTree(const std::string& name) const {
    const std::optional<std::uint32_t> slot = _forest->placed().names.find(name);
    return slot ? std::optional(_forest->placed().idOf(*slot)) : std::nullopt;
}

std::string ForestSimulation::nameOf(TreeId tree) const {
    return holds(tree) ? _forest->placed().names.of(static_cast<std::uint32_t>(slotOfTree(tree)))
                       : std::string();
}

std::optional<TreePlacement> ForestSimulation::placementOf(TreeId tree) const {
    return holds(tree) ? std::optional(_forest->placed().placementOf(slotOfTree(tree))) : std::nullopt;
}

Diagnostics ForestSimulation::setSeason(float season) {
    return _forest->setSeason(season);
}

float ForestSimulation::season() const {
    return _forest->placed().season();
}

Diagnostics ForestSimulation::setWind(Wind wind) {
    return _forest->wind()->set(std::move(wind));
}

Wind ForestSimulation::wind() const {
    return *_forest->wind()->get();
}

Diagnostics ForestSimulation::setCanopy(const CanopySettings& canopy) {
    return _forest->setCanopy(canopy);
}

const CanopySettings& ForestSimulation::canopy() const {
    return _forest->canopy();
}

void ForestSimulation::setExecutor(Executor executor) {
    _forest->setExecutor(std::move(executor));
}

Executor ForestSimulation::executor() const {
    return _forest->hostExecutor() ? _forest->hostExecutor() : ThreadPool::executor();
}

bool ForestSimulation::advance(double time) {
    return _forest->advance(time);
}

void ForestSimulation::reset() {
    _forest->reset();
}

const std::vector<TreeDamage>& ForestSimulation::damage() const {
    return _forest->damage();
}

bool ForestSimulation::isStanding(TreeId tree) const {
    return _forest->isStanding(tree);
}

TreeMotion ForestSimulation::motion(TreeId tree) const {
    return holds(tree) ? _forest->motion(slotOfTree(tree)) : TreeMotion();
}

TreeMotion ForestSimulation::motion(TreeId tree, UnitValues& values) const {
    return holds(tree) ? _forest->motion(slotOfTree(tree), values) : TreeMotion();
}

UnitMotion ForestSimulation::unitMotion(TreeId tree, std::size_t unit) const {
    const bool isKnown = holds(tree) && unit < skeleton(*modelOf(tree)).units.size();
    return isKnown ? _forest->unitMotion(slotOfTree(tree), unit) : UnitMotion();
}

std::optional<TreeSway> ForestSimulation::sway(TreeId tree) const {
    return _forest->sway(tree);
}

std::vector<BranchLoad> ForestSimulation::branchLoads(TreeId tree) const {
    return _forest->branchLoads(tree);
}

} // namespace osgTreeWind
