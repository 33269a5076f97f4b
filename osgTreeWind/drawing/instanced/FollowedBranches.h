// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osg/Group>

#include <map>

namespace osgTreeWind {

/// The transforms of an InstancedForest that move with branches and carry nodes of a host.
class FollowedBranches : public osg::Group {
public:
    FollowedBranches();

    /// @return the transform of a branch, created on the first call; null if there is no such branch.
    BranchTransform* branch(const ForestSimulation& simulation, TreeId tree, unsigned unit);
    /// Removes the transform of a branch. @return false if there was none.
    bool releaseBranch(TreeId tree, unsigned unit);
    bool hasBranches(TreeId tree) const { return _branches.count(tree) > 0; }
    /// Moves the transforms of a tree after it was changed, to the same units of the new tree.
    void treeChanged(const ForestSimulation& simulation, TreeId tree);
    /// Moves all transforms to the current poses. Those of branches that no longer exist stay where they are.
    void update(const ForestSimulation& simulation);

protected:
    ~FollowedBranches() override = default;

private:
    void updateBranches(const ForestSimulation& simulation, TreeId tree);

    std::map<TreeId, std::map<unsigned, osg::ref_ptr<BranchTransform>>> _branches;
};

} // namespace osgTreeWind
