// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/FollowedBranches.h>

#include <osgTreeWind/gpu/OsgConversions.h>

namespace osgTreeWind {

FollowedBranches::FollowedBranches() {
    setName("followed branches");
    setDataVariance(osg::Object::DYNAMIC);
}

BranchTransform* FollowedBranches::follow(const ForestSimulation& simulation, TreeId tree, unsigned unit) {
    if (!simulation.holds(tree))
        return nullptr;
    const PlacedTree& placed = simulation.trees()[simulation.slotOf(tree)];
    const std::vector<BranchUnit>& units = simulation.forest().modelOf(placed).skeleton.units;
    if (unit >= units.size())
        return nullptr;
    osg::ref_ptr<BranchTransform>& branch = _branches[tree][unit];
    if (!branch) {
        branch = new BranchTransform(unit, toOsg(placed.scale.axes * units[unit].base));
        addChild(branch);
        place(simulation, tree);
    }
    return branch;
}

void FollowedBranches::update(const ForestSimulation& simulation) {
    for (const auto& [tree, branches] : _branches)
        if (simulation.holds(tree))
            place(simulation, tree);
}

void FollowedBranches::place(const ForestSimulation& simulation, TreeId tree) {
    const std::size_t slot = simulation.slotOf(tree);
    const PlacedTree& placed = simulation.trees()[slot];
    const TreeMotion motion = simulation.motion(slot, _values);
    const osg::Matrix stand = osg::Matrix::rotate(static_cast<double>(placed.heading), osg::Z_AXIS) *
                              osg::Matrix::translate(toOsg(placed.position));
    for (const auto& [unit, branch] : _branches[tree]) {
        if (unit >= motion.poses.size) // it has become a tree of fewer branches
            continue;
        const UnitPose& pose = motion.poses[unit];
        branch->setMatrix(osg::Matrix::rotate(toOsg(pose.rotation)) *
                          osg::Matrix::translate(toOsg(pose.translation)) * stand);
    }
}

} // namespace osgTreeWind
