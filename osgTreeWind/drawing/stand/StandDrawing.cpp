// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/StandDrawing.h>

#include <osgTreeWind/drawing/stand/FollowedBranches.h>
#include <osgTreeWind/drawing/stand/TreeStand.h>
#include <osgTreeWind/motion/SimulationParts.h>

#include <osg/Notify>

#include <utility>

namespace osgTreeWind {

namespace {

std::shared_ptr<ForestSimulation> swaying(const std::shared_ptr<ForestSimulation>& given) {
    if (given && SimulationParts::modal(*given))
        return given;
    OSG_WARN << "osgTreeWind: expected a simulation under the law modal; no trees are drawn" << std::endl;
    return std::make_shared<ForestSimulation>(ForestDescription());
}

} // namespace

StandDrawing::StandDrawing() : StandDrawing(std::make_shared<ForestSimulation>(ForestDescription())) {}

StandDrawing::StandDrawing(const std::shared_ptr<ForestSimulation>& simulation)
    : _simulation(swaying(simulation)), _trees(new TreeStand(_simulation)), _followed(new FollowedBranches) {
    addChild(_trees);
    addChild(_followed);
}

StandDrawing::StandDrawing(std::shared_ptr<ForestSimulation> simulation, const StandResources& resources)
    : _simulation(std::move(simulation)), _trees(new TreeStand(_simulation, resources)),
      _followed(new FollowedBranches) {
    addChild(_trees);
    addChild(_followed);
}

StandDrawing::StandDrawing(const StandDrawing& other, const osg::CopyOp&)
    : StandDrawing(other._simulation, other._trees->resources()) {}

StandDrawing::~StandDrawing() = default;

bool StandDrawing::setBarkState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::ownBark, species, state);
}

bool StandDrawing::setLeafState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::ownLeaves, species, state);
}

bool StandDrawing::setState(osg::ref_ptr<osg::StateSet> SpeciesLooks::*own, std::size_t species,
                            osg::StateSet* state) {
    std::vector<SpeciesLooks>& looks = _trees->resources().looks;
    if (species < looks.size())
        looks[species].*own = state;
    return species < looks.size();
}

bool StandDrawing::setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves) {
    std::vector<osg::ref_ptr<ModelResources>>& models = _trees->resources().models;
    if (model >= models.size())
        return false;
    models[model] = new ModelResources(*models[model], bark, leaves);
    return true;
}

osg::ref_ptr<ForestDrawing> StandDrawing::again(std::shared_ptr<ForestSimulation> simulation) const {
    const bool isAlike = simulation && SimulationParts::modal(*simulation) &&
                         SimulationParts::models(*simulation) == SimulationParts::models(*_simulation);
    if (!isAlike)
        return new StandDrawing(simulation);
    return new StandDrawing(std::move(simulation), _trees->resources());
}

void StandDrawing::update(const osg::FrameStamp& stamp) {
    _simulation->advance(stamp.getSimulationTime());
    _trees->update(stamp.getFrameNumber(), stamp.getSimulationTime());
    _followed->update(*_simulation);
}

void StandDrawing::treeChanged(std::size_t slot) {
    if (slot >= _simulation->slotCount())
        return;
    _trees->treeChanged(slot);
    _followed->treeChanged(*_simulation, _simulation->idOf(slot));
    dirtyBound(); // which the drawable's box is no part of
}

void StandDrawing::speciesAdded() {
    _trees->speciesAdded();
}

void StandDrawing::seasonChanged() {
    _trees->seasonChanged();
}

BranchTransform* StandDrawing::follow(TreeId tree, unsigned unit) {
    BranchTransform* branch = _followed->follow(*_simulation, tree, unit);
    if (branch)
        _trees->keepNear(_simulation->slotOf(tree), true);
    return branch;
}

bool StandDrawing::unfollow(TreeId tree, unsigned unit) {
    if (!_followed->unfollow(tree, unit))
        return false;
    if (_simulation->holds(tree) && !_followed->follows(tree))
        _trees->keepNear(_simulation->slotOf(tree), false);
    return true;
}

osg::BoundingSphere StandDrawing::computeBound() const {
    osg::BoundingSphere bound(_trees->reach());
    bound.expandBy(_followed->getBound());
    return bound;
}

} // namespace osgTreeWind
