// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/ForestTechnique.h>

#include <osg/Geometry>

namespace osgTreeWind {

class FollowedBranches;
class InstancedTrees;
struct SpeciesLooks;
struct InstancedResources;

/// Draws trees under the law `modal` with instancing, and keeps transforms for followed branches.
///
///     if (InstancedForest* instances = forest->getInstanced())
///         instances->setLeafState(0, ours); // of the first species
class OSGTREEWIND_EXPORT InstancedForest : public ForestTechnique {
public:
    InstancedForest();
    /// Draws the trees of a simulation, like setSimulation().
    explicit InstancedForest(const std::shared_ptr<ForestSimulation>& simulation);
    /// A copy without trees. If it receives trees of the same species in the same season, it shares the
    /// geometry and state of the original, including those set by the host.
    InstancedForest(const InstancedForest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, InstancedForest)

    /// Applies a host's state after that of the bark of a species. A program in it replaces the built-in
    /// one and finds `treePlace`, `treeSize` and `treeState` of a tree at the attribute
    /// locations 12, 13 and 14 (shaders/instance.glsl). Not during a traversal.
    /// @param species index into the species of the description. @param state null removes it.
    /// @return false if there is no such species.
    bool setBarkState(std::size_t species, osg::StateSet* state);
    /// Likewise for leaves.
    bool setLeafState(std::size_t species, osg::StateSet* state);
    /// Replaces the geometry of a model (ForestSimulation::modelOf()) at every tier with branches; null draws
    /// nothing. Geometry has buffer objects and the arrays of shaders/bark_vertex.glsl and
    /// leaf_corner.glsl, which include the index of the unit that moves a vertex. Not during a traversal.
    /// @return false if there is no such model.
    bool setGeometry(std::size_t model, osg::Geometry* bark, osg::Geometry* leaves);

    /// Draws no trees, with a warning, for null and for a simulation under a branchwise law. Removes state
    /// and geometry that a host has set.
    void setSimulation(std::shared_ptr<ForestSimulation> simulation) override;
    void update(const osg::FrameStamp& stamp, bool moved) override;
    void treeChanged(TreeId tree) override;
    void speciesAdded() override;
    void seasonChanged() override;
    BranchTransform* branch(TreeId tree, unsigned unit) override;
    bool releaseBranch(TreeId tree, unsigned unit) override;
    InstancedForest* asInstancedForest() override { return this; }

    /// A conservative bound that includes the sway of the trees. Bounding boxes hold the trees at rest.
    osg::BoundingSphere computeBound() const override;

protected:
    ~InstancedForest() override;

private:
    friend InstancedTrees& instancedTrees(const InstancedForest& forest);
    void setTrees(const osg::ref_ptr<InstancedTrees>& trees,
                  const std::shared_ptr<ForestSimulation>& simulation);
    bool setState(osg::ref_ptr<osg::StateSet> SpeciesLooks::*own, std::size_t species, osg::StateSet* state);

    /// Those of the original, until a copy receives trees.
    std::unique_ptr<InstancedResources> _sharedResources;
    osg::ref_ptr<InstancedTrees> _trees;
    osg::ref_ptr<FollowedBranches> _followed;
};

} // namespace osgTreeWind
