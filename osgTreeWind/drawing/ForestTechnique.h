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

/// How a Forest draws its trees: the child of the Forest that holds what is drawn. A host derives its own and
/// hands it to Forest::setTechnique(). This one draws nothing, and moves the trees.
///
///     class Lines : public osgTreeWind::ForestTechnique {
///     public:
///         void setSimulation(std::shared_ptr<osgTreeWind::ForestSimulation> simulation) override {
///             ForestTechnique::setSimulation(simulation); // removes the children
///             if (simulation)
///                 addChild(drawingOf(*simulation));
///         }
///         void update(const osg::FrameStamp& stamp) override {
///             ForestTechnique::update(stamp); // moves the trees
///             if (getSimulation())
///                 moveDrawing(*getSimulation());
///         }
///     };
///
/// A technique belongs to one Forest. All functions are called in the update traversal or between frames.
class OSGTREEWIND_EXPORT ForestTechnique : public osg::Group {
public:
    ForestTechnique();
    /// Copies the settings; the Forest that gets the copy calls its setSimulation(), which makes the
    /// children.
    ForestTechnique(const ForestTechnique& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, ForestTechnique)

        /// Draws these trees from now on, in place of those before. The Forest calls it with each new
        /// description, and when it takes the technique. This one removes all children. If it throws, the
        /// Forest keeps its former trees.
        /// @param simulation which update() moves on; null: no trees.
        virtual void setSimulation(std::shared_ptr<ForestSimulation> simulation);
    ForestSimulation* getSimulation() const { return _simulation.get(); } ///< May be null.

    /// Advances the simulation to the frame's simulation time, and updates what is drawn.
    virtual void update(const osg::FrameStamp& stamp);
    /// A tree was added, moved, changed or removed. @param slot of ForestSimulation.
    virtual void treeChanged(std::size_t slot);
    virtual void speciesAdded();  ///< The simulation has a species more, whose trees may come.
    virtual void seasonChanged(); ///< The simulation is in another season.

    /// The transform that moves with a unit of a tree, always the same one; null where there is no such unit,
    /// or the technique has no transforms, as this one.
    virtual BranchTransform* follow(TreeId tree, unsigned unit);
    /// Removes the transform that follow() made, and its children. @return false if it was not followed.
    virtual bool unfollow(TreeId tree, unsigned unit);

    virtual InstancedForest* asInstancedForest();   ///< This, if it is one; else null.
    virtual BranchwiseForest* asBranchwiseForest(); ///< This, if it is one; else null.

protected:
    ~ForestTechnique() override;

private:
    std::shared_ptr<ForestSimulation> _simulation;
};

} // namespace osgTreeWind
