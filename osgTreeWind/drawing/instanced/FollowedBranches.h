// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osg/Group>

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

} // namespace osgTreeWind
