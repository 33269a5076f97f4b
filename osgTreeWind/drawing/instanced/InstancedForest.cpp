// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedForest.h>

#include <osgTreeWind/drawing/instanced/FollowedBranches.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/Notify>

namespace osgTreeWind {
namespace {

std::shared_ptr<ForestSimulation> modalOrEmpty(const std::shared_ptr<ForestSimulation>& given) {
    if (given && movingForest(*given).modal())
        return given;
    OSG_WARN << "osgTreeWind: expected a simulation under the law modal; no trees are drawn" << std::endl;
    return std::make_shared<ForestSimulation>(ForestDescription());
}

} // namespace

InstancedForest::InstancedForest()
    : InstancedForest(std::make_shared<ForestSimulation>(ForestDescription())) {}

InstancedForest::InstancedForest(const std::shared_ptr<ForestSimulation>& simulation) {
    InstancedForest::setSimulation(simulation);
}

InstancedForest::InstancedForest(const InstancedForest& other, const osg::CopyOp& copyop)
    : ForestTechnique(other, copyop),
      _sharedResources(std::make_unique<InstancedResources>(
          other._sharedResources ? *other._sharedResources : other._trees->resources())) {
    setTrees(new InstancedTrees, std::make_shared<ForestSimulation>(ForestDescription()));
}

InstancedForest::~InstancedForest() = default;

InstancedTrees& instancedTrees(const InstancedForest& forest) {
    return *forest._trees;
}

bool InstancedForest::setBarkState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::hostBark, species, state);
}

bool InstancedForest::setLeafState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::hostLeaves, species, state);
}

bool InstancedForest::setState(osg::ref_ptr<osg::StateSet> SpeciesLooks::*own, std::size_t species,
                               osg::StateSet* state) {
    std::vector<SpeciesLooks>& looks = _trees->resources().looks;
    if (species < looks.size())
        looks[species].*own = state;
    return species < looks.size();
}

bool InstancedForest::setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves) {
    std::vector<osg::ref_ptr<ModelResources>>& models = _trees->resources().models;
    if (model >= models.size())
        return false;
    _trees->resources().makeModels(*getSimulation(), {model});
    models[model] = new ModelResources(*models[model], bark, leaves);
    return true;
}

void InstancedForest::setSimulation(std::shared_ptr<ForestSimulation> given) {
    const std::shared_ptr<ForestSimulation> simulation = modalOrEmpty(given);
    const bool shares = _sharedResources && _sharedResources->matches(*simulation);
    setTrees(shares ? new InstancedTrees(simulation, *_sharedResources) : new InstancedTrees(simulation),
             simulation);
    _sharedResources.reset();
}

void InstancedForest::setTrees(const osg::ref_ptr<InstancedTrees>& trees,
                               const std::shared_ptr<ForestSimulation>& simulation) {
    const osg::ref_ptr<FollowedBranches> followed = new FollowedBranches;
    ForestTechnique::setSimulation(simulation);
    _trees = trees;
    _followed = followed;
    addChild(_trees);
    addChild(_followed);
}

void InstancedForest::update(const osg::FrameStamp& stamp, bool) {
    _trees->update(stamp.getFrameNumber(), stamp.getSimulationTime());
    _followed->update(*getSimulation());
}

void InstancedForest::treeChanged(TreeId tree) {
    if (slotOfTree(tree) >= movingForest(*getSimulation()).trees().size())
        return;
    _trees->treeChanged(slotOfTree(tree));
    _followed->treeChanged(*getSimulation(), tree);
    dirtyBound(); // the drawable does not: computeBound() does not use its box
}

void InstancedForest::speciesAdded() {
    _trees->speciesAdded();
}

void InstancedForest::seasonChanged() {
    _trees->seasonChanged();
}

BranchTransform* InstancedForest::branch(TreeId tree, unsigned unit) {
    BranchTransform* branch = _followed->branch(*getSimulation(), tree, unit);
    if (branch)
        _trees->keepNear(slotOfTree(tree), true);
    return branch;
}

bool InstancedForest::releaseBranch(TreeId tree, unsigned unit) {
    if (!_followed->releaseBranch(tree, unit))
        return false;
    if (getSimulation()->holds(tree) && !_followed->hasBranches(tree))
        _trees->keepNear(slotOfTree(tree), false);
    return true;
}

osg::BoundingSphere InstancedForest::computeBound() const {
    osg::BoundingSphere bound(_trees->swayBounds());
    bound.expandBy(_followed->getBound());
    return bound;
}

} // namespace osgTreeWind
