// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/ForestTechnique.h>

#include <osg/Geometry>

namespace osgTreeWind {

class FollowedBranches;
class InstancedTrees;
struct SpeciesLooks;
struct InstancedResources;

/// Trees under the law `modal`: instances, and transforms for the branches that someone follows.
///
///     if (InstancedForest* instances = forest->getInstanced())
///         instances->setLeafState(0, ours); // of the first species
class OSGTREEWIND_EXPORT InstancedForest : public ForestTechnique {
public:
    /// No trees.
    InstancedForest();
    /// Draws the trees of a simulation, as setSimulation().
    explicit InstancedForest(const std::shared_ptr<ForestSimulation>& simulation);
    /// Given trees of the same species in the same season, it shares what they are drawn from, and what a
    /// host has set for them.
    InstancedForest(const InstancedForest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, InstancedForest)

        /// Puts state after that of a species' bark or leaves (index into the description's); null takes it
        /// away. One with a program of its own replaces ours: it finds a tree's `treePlace`, `treeSize` and
        /// `treeState` at the attribute locations 12, 13 and 14 (shaders/instance.glsl). Not during a
        /// traversal. @return false where there is no such species.
        bool setBarkState(std::size_t species, osg::StateSet* state);
    /// The same for leaves.
    bool setLeafState(std::size_t species, osg::StateSet* state);
    /// Draws the trees of a model (ForestSimulation::modelOf()) from these, at every tier with
    /// branches, null for none: geometry with buffer objects and the arrays of shaders/instance_bark.vert and
    /// instance_leaf.vert, the index of the unit that moves a vertex among them. Not during a traversal.
    /// @return false where there is no such model.
    bool setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves);

    /// Draws no trees, and warns, for null or a law of a branch. What a host has set for species and models
    /// goes with them.
    void setSimulation(std::shared_ptr<ForestSimulation> simulation) override;
    void update(const osg::FrameStamp& stamp) override;
    void treeChanged(std::size_t slot) override;
    void speciesAdded() override;
    void seasonChanged() override;
    BranchTransform* follow(TreeId tree, unsigned unit) override;
    bool unfollow(TreeId tree, unsigned unit) override;
    InstancedForest* asInstancedForest() override { return this; }

    /// As far as the trees may sway, so that none is culled that is seen; boxes are of trees at rest.
    osg::BoundingSphere computeBound() const override;

protected:
    ~InstancedForest() override;

private:
    friend struct InstancedParts;
    void show(const osg::ref_ptr<InstancedTrees>& trees, const std::shared_ptr<ForestSimulation>& simulation);
    bool setState(osg::ref_ptr<osg::StateSet> SpeciesLooks::*own, std::size_t species, osg::StateSet* state);

    std::unique_ptr<InstancedResources> _toShare; ///< Of the original, in a copy that has no trees yet.
    osg::ref_ptr<InstancedTrees> _trees;
    osg::ref_ptr<FollowedBranches> _followed;
};

} // namespace osgTreeWind
