// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/gpu/EntryGuard.h>

#include <osg/FrameStamp>
#include <osg/Group>
#include <osg/NodeVisitor>
#include <osgDB/Options>

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace osgTreeWind {

class FarCrowns;
class ForestSimulation;
struct TreePlacement;

/// Has the tiles of a forest come and go with its cameras: each cull traversal asks the viewer's pager
/// (osgDB::DatabasePager) for those in range of its eye, each update puts up what has arrived and takes away
/// what nobody is near any more.
///
/// One node for all tiles, and not a PagedLOD for each: those are looked at in every traversal, ask only for
/// what the frustum holds, and ask for a missing file in every frame.
class TilePager : public osg::Group {
public:
    /// Puts up a tree in the simulation. @return noTree where it cannot be put up.
    using AddTree = std::function<TreeId(const TreePlacement&)>;

    /// @param simulation of a forest that has tiles. @param addTree called in update() and bring().
    TilePager(std::shared_ptr<const ForestSimulation> simulation, AddTree addTree);
    /// The simulation is in another season. In update.
    void seasonChanged();

    struct Changes {
        std::vector<TreeId> near;    ///< Put up so near an eye that one sees how they begin to sway.
        std::vector<TreeId> leaving; ///< To be unloaded: their tiles are far.
    };
    /// Puts up trees that have arrived, the nearest tiles first and for a quarter of the time since the last
    /// update at most, but for the first ones. In update.
    Changes update(const osg::FrameStamp& stamp);
    /// Reads the tile of a tree that is not there, whatever is near, and puts it up. In update or between
    /// frames.
    void bring(const std::string& name);
    /// Metres from an eye to the nearest tile that is to be there and is not, infinite where all are; those
    /// that cannot be read do not count.
    double nearestMissing() const;
    /// How many tiles are there, with all of their trees.
    std::size_t countThere() const;

    void traverse(osg::NodeVisitor& visitor) override;
    osg::BoundingSphere computeBound() const override;

protected:
    ~TilePager() override;

private:
    /// A tile that is near some eye, or was a short while ago.
    struct Slot {
        osg::ref_ptr<osg::Group> arrival = new osg::Group; ///< Where the pager puts it.
        osg::ref_ptr<osg::Referenced> request;
        unsigned asked = 0, near = 0;                     ///< Frame numbers.
        double nearTime = 0.0, nextTry = 0.0, wait = 0.0; ///< Seconds of reference time.
        double distance = 0.0;                            ///< Of the nearest eye, metres.
        std::vector<TreePlacement> coming;                ///< In reverse.
        std::vector<TreeId> standing;
        bool arrived = false;
    };

    void askForTiles(osg::NodeVisitor& visitor);
    void ask(Slot& slot, const std::string& file, float priority, osg::NodeVisitor& visitor);
    void receiveCrowns(double now);
    double distanceTo(std::size_t tile, const glm::dvec3& eye) const;
    double nearest() const; ///< nearestMissing()
    void failed(Slot& slot, double now) const;
    void receive(Slot& slot, std::size_t tile, const osg::ref_ptr<osg::Node>& file, double now);
    void putUp(Slot& slot, double until, std::vector<TreeId>& near) const;
    void leave(Slot& slot, std::vector<TreeId>& leaving);
    std::optional<std::size_t> tileWith(const std::string& name) const;

    EntryGuard _guard;
    std::shared_ptr<const ForestSimulation> _simulation;
    AddTree _addTree;
    ForestTiles _tiles;
    glm::dvec3 _origin;                          ///< Of the forest.
    osg::ref_ptr<const osgDB::Options> _options; ///< With which files are read.
    mutable std::mutex _mutex;                   // guards all below: cull traversals may run at a time
    std::map<std::size_t, Slot> _slots;
    Slot _crownFile;
    osg::ref_ptr<FarCrowns> _crowns; ///< Null before they are there.
    std::set<std::size_t> _blamed;   ///< Tiles that a warning was given of.
    std::set<std::string> _damaged;  ///< Trees that stayed as their tiles left.
    unsigned _frame = 0;             ///< Of the last update, as
    double _now = 0.0;               ///< its reference time, seconds.
    glm::dvec3 _eye{0.0};            ///< Of the last cull traversal, in the forest's frame.
    bool _pagerless = false;
    bool _wasWhole = false; ///< All that was in range has been there once.
    double _updated = 0.0;  ///< When the last update was, seconds of osg::Timer.
};

} // namespace osgTreeWind
