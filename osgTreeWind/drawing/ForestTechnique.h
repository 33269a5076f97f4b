// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osg/FrameStamp>
#include <osg/Group>

#include <memory>

namespace osgTreeWind {

class BranchTransform;
class BranchwiseForest;
class ForestSimulation;
class InstancedForest;

/// Base class of the ways to draw a Forest: the child of the Forest that holds the drawables. A host derives
/// its own technique and passes it to Forest::setTechnique(). The Forest moves the trees. This class draws
/// nothing.
///
///     class Lines : public osgTreeWind::ForestTechnique {
///     public:
///         void setSimulation(std::shared_ptr<osgTreeWind::ForestSimulation> simulation) override {
///             ForestTechnique::setSimulation(simulation); // removes the children
///             if (simulation)
///                 addChild(drawingOf(*simulation));
///         }
///         void update(const osg::FrameStamp&, bool moved) override {
///             if (moved)
///                 moveDrawing(*getSimulation());
///         }
///     };
///
/// A technique belongs to one Forest. All functions are called in the update traversal or between frames.
class OSGTREEWIND_EXPORT ForestTechnique : public osg::Group {
public:
    ForestTechnique();
    /// Copies the settings. The Forest that receives the copy calls setSimulation(), which adds the children.
    ForestTechnique(const ForestTechnique& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, ForestTechnique)

    /// Replaces the trees to draw. The Forest calls it when it receives the technique or a new
    /// description. The base class removes all children. If it throws, the Forest keeps its former trees.
    /// @param simulation advanced by the Forest; null for no trees.
    virtual void setSimulation(std::shared_ptr<ForestSimulation> simulation);
    ForestSimulation* getSimulation() const { return _simulation.get(); } ///< May be null.

    /// Whether this technique takes the steps of the trees itself, as shaders do for the laws of the thesis.
    /// Then the Forest only samples the wind before update(). The base class returns false.
    virtual bool stepsItself() const;
    /// Updates the drawables, after the Forest has advanced the trees. The base class does nothing.
    /// @param stamp with the simulation time to which the trees were advanced. @param moved whether they took
    /// a step, or with stepsItself(), whether one is due.
    virtual void update(const osg::FrameStamp& stamp, bool moved);
    /// Called after a tree was added, moved, changed, broken or removed.
    virtual void treeChanged(TreeId tree);
    virtual void speciesAdded();  ///< Called after a species was added, before its first tree.
    virtual void seasonChanged(); ///< Called after the season of the simulation changed.

    /// @return the transform that moves with a unit of a tree, the same one at each call; null if there is no
    /// such unit or the technique has no transforms. The base class returns null.
    virtual BranchTransform* branch(TreeId tree, unsigned unit);
    /// Removes the transform that branch() made, and its children. @return false if there was none.
    virtual bool releaseBranch(TreeId tree, unsigned unit);

    virtual InstancedForest* asInstancedForest();   ///< Null for other techniques.
    virtual BranchwiseForest* asBranchwiseForest(); ///< Null for other techniques.

protected:
    ~ForestTechnique() override;

private:
    std::shared_ptr<ForestSimulation> _simulation;
};

} // namespace osgTreeWind
