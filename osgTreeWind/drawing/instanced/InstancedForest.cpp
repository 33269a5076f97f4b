// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedForest.h>

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>

#include <osg/Notify>

#include <map>

namespace osgTreeWind {

/// Branches that someone hangs things on: transforms that follow the state of a simulation under `modal`. A
/// part of an InstancedForest.
class FollowedBranches : public osg::Group {
public:
    FollowedBranches();

    /// The one of that branch; null where there is none.
    BranchTransform* follow(const ForestSimulation& simulation, TreeId tree, unsigned unit);
    /// Takes it away. @return false where none is followed.
    bool unfollow(TreeId tree, unsigned unit);
    bool follows(TreeId tree) const { return _branches.count(tree) > 0; }
    /// A tree is another one by now: sets those on it where it has their branches.
    void treeChanged(const ForestSimulation& simulation, TreeId tree);
    /// Sets all where their branches are now. Those that are gone, with their tree or without, stay.
    void update(const ForestSimulation& simulation);

protected:
    ~FollowedBranches() override = default;

private:
    void place(const ForestSimulation& simulation, TreeId tree);

    std::map<TreeId, std::map<unsigned, osg::ref_ptr<BranchTransform>>> _branches;
};

FollowedBranches::FollowedBranches() {
    setName("followed branches");
    setDataVariance(osg::Object::DYNAMIC);
}

BranchTransform* FollowedBranches::follow(const ForestSimulation& simulation, TreeId tree, unsigned unit) {
    if (!simulation.holds(tree))
        return nullptr;
    const PlacedTree& placed = SimulationParts::trees(simulation)[simulation.slotOf(tree)];
    const std::vector<BranchUnit>& units = SimulationParts::forest(simulation).modelOf(placed).skeleton.units;
    if (unit >= units.size())
        return nullptr;
    osg::ref_ptr<BranchTransform>& branch = _branches[tree][unit];
    if (!branch) {
        branch = new BranchTransform(unit, osg::Vec3());
        addChild(branch);
        place(simulation, tree);
    }
    return branch;
}

bool FollowedBranches::unfollow(TreeId tree, unsigned unit) {
    const auto of = _branches.find(tree);
    if (of == _branches.end())
        return false;
    const auto branch = of->second.find(unit);
    if (branch == of->second.end())
        return false;
    removeChild(branch->second);
    of->second.erase(branch);
    if (of->second.empty())
        _branches.erase(of);
    return true;
}

void FollowedBranches::treeChanged(const ForestSimulation& simulation, TreeId tree) {
    if (simulation.holds(tree) && follows(tree))
        place(simulation, tree);
}

void FollowedBranches::update(const ForestSimulation& simulation) {
    for (const auto& [tree, branches] : _branches)
        if (simulation.holds(tree))
            place(simulation, tree);
}

void FollowedBranches::place(const ForestSimulation& simulation, TreeId tree) {
    const std::size_t slot = simulation.slotOf(tree);
    const PlacedTree& placed = SimulationParts::trees(simulation)[slot];
    const std::vector<BranchUnit>& units = SimulationParts::forest(simulation).modelOf(placed).skeleton.units;
    const osg::Matrix toForest = osg::Matrix::rotate(static_cast<double>(placed.heading), osg::Z_AXIS) *
                                 osg::Matrix::translate(toOsg(placed.position));
    for (const auto& [unit, branch] : _branches[tree]) {
        if (unit >= units.size()) // it has become a tree of fewer branches
            continue;
        const UnitMotion motion = simulation.unitMotion(slot, unit);
        branch->setPose(toOsg(placed.scale.axes * units[unit].base),
                        osg::Matrix::rotate(toOsg(motion.pose.rotation)) *
                            osg::Matrix::translate(toOsg(motion.pose.translation)) * toForest,
                        toOsg(motion.rotation));
    }
}

namespace {

std::shared_ptr<ForestSimulation> swaying(const std::shared_ptr<ForestSimulation>& given) {
    if (given && SimulationParts::modal(*given))
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
    : ForestTechnique(other, copyop), _toShare(std::make_unique<InstancedResources>(
                                          other._toShare ? *other._toShare : other._trees->resources())) {
    show(new InstancedTrees, std::make_shared<ForestSimulation>(ForestDescription()));
}

InstancedForest::~InstancedForest() = default;

bool InstancedForest::setBarkState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::ownBark, species, state);
}

bool InstancedForest::setLeafState(std::size_t species, osg::StateSet* state) {
    return setState(&SpeciesLooks::ownLeaves, species, state);
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
    models[model] = new ModelResources(*models[model], bark, leaves);
    return true;
}

void InstancedForest::setSimulation(std::shared_ptr<ForestSimulation> given) {
    const std::shared_ptr<ForestSimulation> simulation = swaying(given);
    const bool shares = _toShare && _toShare->areOf(*simulation);
    show(shares ? new InstancedTrees(simulation, *_toShare) : new InstancedTrees(simulation), simulation);
    _toShare.reset();
}

void InstancedForest::show(const osg::ref_ptr<InstancedTrees>& trees,
                           const std::shared_ptr<ForestSimulation>& simulation) {
    const osg::ref_ptr<FollowedBranches> followed = new FollowedBranches;
    ForestTechnique::setSimulation(simulation);
    _trees = trees;
    _followed = followed;
    addChild(_trees);
    addChild(_followed);
}

void InstancedForest::update(const osg::FrameStamp& stamp) {
    ForestTechnique::update(stamp);
    _trees->update(stamp.getFrameNumber(), stamp.getSimulationTime());
    _followed->update(*getSimulation());
}

void InstancedForest::treeChanged(std::size_t slot) {
    if (slot >= getSimulation()->slotCount())
        return;
    _trees->treeChanged(slot);
    _followed->treeChanged(*getSimulation(), getSimulation()->idOf(slot));
    dirtyBound(); // which the drawable's box is no part of
}

void InstancedForest::speciesAdded() {
    _trees->speciesAdded();
}

void InstancedForest::seasonChanged() {
    _trees->seasonChanged();
}

BranchTransform* InstancedForest::follow(TreeId tree, unsigned unit) {
    BranchTransform* branch = _followed->follow(*getSimulation(), tree, unit);
    if (branch)
        _trees->keepNear(getSimulation()->slotOf(tree), true);
    return branch;
}

bool InstancedForest::unfollow(TreeId tree, unsigned unit) {
    if (!_followed->unfollow(tree, unit))
        return false;
    if (getSimulation()->holds(tree) && !_followed->follows(tree))
        _trees->keepNear(getSimulation()->slotOf(tree), false);
    return true;
}

osg::BoundingSphere InstancedForest::computeBound() const {
    osg::BoundingSphere bound(_trees->reach());
    bound.expandBy(_followed->getBound());
    return bound;
}

} // namespace osgTreeWind
