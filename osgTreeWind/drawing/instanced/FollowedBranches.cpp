// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FollowedBranches.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

namespace osgTreeWind {

FollowedBranches::FollowedBranches() {
    setName("followed branches");
    setDataVariance(osg::Object::DYNAMIC);
}

BranchTransform* FollowedBranches::branch(const ForestSimulation& simulation, TreeId tree, unsigned unit) {
    if (!simulation.holds(tree))
        return nullptr;
    const PlacedTree& placed = movingForest(simulation).trees()[slotOfTree(tree)];
    const std::vector<BranchUnit>& units = movingForest(simulation).placed().modelOf(placed).skeleton.units;
    if (unit >= units.size())
        return nullptr;
    osg::ref_ptr<BranchTransform>& branch = _branches[tree][unit];
    if (!branch) {
        branch = new BranchTransform(unit, osg::Vec3());
        addChild(branch);
        updateBranches(simulation, tree);
    }
    return branch;
}

bool FollowedBranches::releaseBranch(TreeId tree, unsigned unit) {
    const auto branches = _branches.find(tree);
    if (branches == _branches.end())
        return false;
    const auto branch = branches->second.find(unit);
    if (branch == branches->second.end())
        return false;
    removeChild(branch->second);
    branches->second.erase(branch);
    if (branches->second.empty())
        _branches.erase(branches);
    return true;
}

void FollowedBranches::treeChanged(const ForestSimulation& simulation, TreeId tree) {
    if (simulation.holds(tree) && hasBranches(tree))
        updateBranches(simulation, tree);
}

void FollowedBranches::update(const ForestSimulation& simulation) {
    for (const auto& [tree, branches] : _branches)
        if (simulation.holds(tree))
            updateBranches(simulation, tree);
}

void FollowedBranches::updateBranches(const ForestSimulation& simulation, TreeId tree) {
    const std::size_t slot = slotOfTree(tree);
    const PlacedTree& placed = movingForest(simulation).trees()[slot];
    const std::vector<BranchUnit>& units = movingForest(simulation).placed().modelOf(placed).skeleton.units;
    const osg::Matrix toForest =
        osg::Matrix::rotate(aboutVertical(placed.heading)) * osg::Matrix::translate(toOsg(placed.position));
    for (const auto& [unit, branch] : _branches[tree]) {
        if (unit >= units.size()) // the changed tree has fewer branches
            continue;
        const UnitMotion motion = movingForest(simulation).unitMotion(slot, unit);
        branch->setPose(toOsg(placed.scale.axes * units[unit].base),
                        osg::Matrix::rotate(toOsg(motion.pose.rotation)) *
                            osg::Matrix::translate(toOsg(motion.pose.translation)) * toForest,
                        toOsg(motion.rotation));
    }
}

} // namespace osgTreeWind
