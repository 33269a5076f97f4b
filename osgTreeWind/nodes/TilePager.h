// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>

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

/// Loads and unloads the tiles of a forest by their distance to the cameras. Each cull traversal requests the
/// tiles in range of its eye from the viewer's pager (osgDB::DatabasePager). Each update adds the trees that
/// have arrived, and lists the trees to unload.
///
/// One node serves all tiles. A PagedLOD per tile would be visited in every traversal, would request only
/// tiles in the frustum, and would request a missing file in every frame.
class TilePager : public osg::Group {
public:
    /// Adds a tree to the simulation. @return empty if that fails.
    using AddTree = std::function<std::optional<TreeId>(const TreePlacement&)>;

    /// @param simulation of a forest with tiles. @param addTree called in update() and loadTree().
    TilePager(std::shared_ptr<const ForestSimulation> simulation, AddTree addTree);
    /// Shows the season of the simulation. In update.
    void seasonChanged();

    struct Changes {
        std::vector<TreeId> addedNearEye; ///< Trees so near an eye that their sway must not start from rest.
        std::vector<TreeId> toUnload;     ///< Trees of tiles out of range.
    };
    /// Adds trees that have arrived, nearest tiles first. Spends at most a quarter of the time since the last
    /// update; all of that time until everything in range is loaded for the first time. In update.
    Changes update(const osg::FrameStamp& stamp);
    /// Loads the tile of a tree by the tree's name, at any distance. In update or between frames.
    void loadTree(const std::string& name);
    /// Distance from an eye to the nearest tile in range that is not loaded yet, metres; infinite if there is
    /// none. Ignores tiles that cannot be read.
    double nearestMissingDistance() const;
    /// Number of tiles whose trees are all in the simulation.
    std::size_t loadedTileCount() const;

    void traverse(osg::NodeVisitor& visitor) override;
    osg::BoundingSphere computeBound() const override;

protected:
    ~TilePager() override;

private:
    /// A tile that is in range of an eye, or was recently.
    struct Slot {
        osg::ref_ptr<osg::Group> requestNode = new osg::Group; ///< The pager adds the file as a child.
        osg::ref_ptr<osg::Referenced> request;
        unsigned requestFrame = 0, nearFrame = 0;                 ///< Frame numbers.
        double nearTime = 0.0, retryTime = 0.0, retryDelay = 0.0; ///< Reference time, seconds.
        double distance = 0.0;                                    ///< To the nearest eye, metres.
        std::vector<TreePlacement> pendingTrees;                  ///< Not added yet, in reverse order.
        std::vector<TreeId> loadedTrees;
        bool isLoaded = false; ///< The file was read.
    };

    void requestTiles(osg::NodeVisitor& visitor);
    void requestFile(Slot& slot, const std::string& file, float priority, osg::NodeVisitor& visitor);
    void receiveCrowns(double now);
    double distanceTo(std::size_t tile, const glm::dvec3& eye) const;
    double findNearestMissing() const; ///< nearestMissingDistance() without the lock.
    void scheduleRetry(Slot& slot, double now) const;
    void receiveTile(Slot& slot, std::size_t tile, const osg::ref_ptr<osg::Node>& file, double now);
    void addPendingTrees(Slot& slot, double until, std::vector<TreeId>& addedNearEye) const;
    void collectTreesToUnload(Slot& slot, std::vector<TreeId>& toUnload);
    std::optional<std::size_t> findTile(const std::string& name) const;

    ExceptionGuard _guard;
    std::shared_ptr<const ForestSimulation> _simulation;
    AddTree _addTree;
    ForestTiles _tiles;
    glm::dvec3 _origin; ///< Of the forest.
    osg::ref_ptr<const osgDB::Options> _options;
    mutable std::mutex _mutex; ///< Guards the members below: cull traversals may run in parallel.
    std::map<std::size_t, Slot> _slots;
    Slot _crownFile;
    osg::ref_ptr<FarCrowns> _crowns;     ///< Null until they are loaded.
    std::set<std::size_t> _warnedTiles;  ///< Unreadable tiles with a warning already given.
    std::set<std::string> _damagedTrees; ///< Names of broken trees that outlived their tiles.
    unsigned _frame = 0;                 ///< Frame number of the last update.
    double _now = 0.0;                   ///< Reference time of the last update, seconds.
    glm::dvec3 _eye{0.0};                ///< Of the last cull traversal, in the forest's frame.
    bool _hasWarnedOfPager = false;
    bool _wasComplete = false; ///< Everything in range has been loaded at least once.
    double _lastUpdate = 0.0;  ///< Clock of osg::Timer, seconds.
};

} // namespace osgTreeWind
