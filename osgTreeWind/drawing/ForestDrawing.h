// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osg/FrameStamp>
#include <osg/Group>

#include <memory>

namespace osgTreeWind {

class BranchTransform;
class ForestSimulation;

/// A way of drawing the trees of a simulation: the one own child of a Forest, which tells it what happens.
/// Everything here in update, or between frames.
class OSGTREEWIND_EXPORT ForestDrawing : public osg::Group {
public:
    /// The same way for another simulation of the same models and species; shares what does not change.
    virtual osg::ref_ptr<ForestDrawing> again(std::shared_ptr<ForestSimulation> simulation) const = 0;
    /// Goes on with the settings of the one whose place it takes, as far as both have them.
    virtual void takeSettings(const ForestDrawing& former) = 0;

    /// Moves the simulation on to the simulation time of a frame, and the trees with it.
    virtual void update(const osg::FrameStamp& stamp) = 0;
    /// A tree was added, moved, changed or removed. @param slot in ForestSimulation::trees().
    virtual void treeChanged(std::size_t slot) = 0;
    /// A species was added to the simulation, whose trees may come.
    virtual void speciesAdded() = 0;
    /// The simulation's season is another one.
    virtual void seasonChanged() = 0;

    /// The transform that goes where that unit of a tree goes, always the same one; null where there is none.
    virtual BranchTransform* follow(TreeId tree, unsigned unit) = 0;
    /// Lets it go, with what hangs on it. @return false where it is not followed.
    virtual bool unfollow(TreeId tree, unsigned unit) = 0;

protected:
    ForestDrawing() { setDataVariance(osg::Object::DYNAMIC); }
    ~ForestDrawing() override = default;
};

} // namespace osgTreeWind
