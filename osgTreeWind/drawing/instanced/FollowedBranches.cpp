// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FollowedBranches.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>

namespace osgTreeWind {

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

} // namespace osgTreeWind
