// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TilePager.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/drawing/crowns/FarCrowns.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/TileReader.h>

#include <osg/Notify>
#include <osg/Timer>
#include <osgDB/ReadFile>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double keepRangeFactor = 1.2; // of the range: tiles are unloaded beyond it
constexpr double keepTime = 5.0;        // seconds that a tile stays loaded out of range,
constexpr unsigned keepFrames = 60;     // and frames
constexpr double minRetryDelay = 2.0,
                 maxRetryDelay = 60.0; // seconds until an unreadable tile is requested again
constexpr double minLoadTime = 0.002, maxLoadTime = 0.25; // seconds per update to add trees
constexpr double visibleSwayDistance = 300.0;             // metres
constexpr double assumedTreeHeight = 50.0;                // metres: upper bound for tiles

/// The program's options, with timeouts for servers that OpenSceneGraph does not set by itself: 10 s for a
/// connection and 60 s for a file.
osg::ref_ptr<osgDB::Options> optionsWithTimeouts() {
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    if (const osgDB::Options* program = osgDB::Registry::instance()->getOptions())
        options = program->cloneOptions();
    std::string text = options->getOptionString();
    if (text.find("OSG_CURL_CONNECTTIMEOUT") == std::string::npos)
        text += " OSG_CURL_CONNECTTIMEOUT=10";
    if (text.find("OSG_CURL_TIMEOUT") == std::string::npos)
        text += " OSG_CURL_TIMEOUT=60";
    options->setOptionString(text);
    return options;
}

} // namespace

TilePager::TilePager(std::shared_ptr<const ForestSimulation> simulation, AddTree addTree)
    : _simulation(std::move(simulation)), _addTree(std::move(addTree)),
      _tiles(*_simulation->description().tiles), _origin(_simulation->description().origin),
      _options(optionsWithTimeouts()) {
    registerTileReader();
}

TilePager::~TilePager() = default;

/// @param eye in the forest's frame, metres.
double TilePager::distanceTo(std::size_t tile, const glm::dvec3& eye) const {
    const glm::dvec2 corner = _tiles.cornerOf(tile);
    const double low = static_cast<double>(_tiles.tiles[tile].low),
                 high = static_cast<double>(_tiles.tiles[tile].high) + assumedTreeHeight;
    const glm::dvec3 from = glm::dvec3(corner, low) - _origin,
                     to = glm::dvec3(corner + _tiles.size, high) - _origin;
    return glm::distance(eye, glm::clamp(eye, from, to));
}

osg::BoundingSphere TilePager::computeBound() const {
    osg::BoundingBox box;
    for (std::size_t i = 0; i < _tiles.tiles.size(); ++i) {
        const ForestTiles::Tile& tile = _tiles.tiles[i];
        if (tile.trees == 0)
            continue;
        const glm::dvec2 corner = _tiles.cornerOf(i);
        box.expandBy(toOsg(glm::vec3(glm::dvec3(corner, tile.low) - _origin)));
        box.expandBy(toOsg(glm::vec3(
            glm::dvec3(corner + _tiles.size, static_cast<double>(tile.high) + assumedTreeHeight) - _origin)));
    }
    return osg::BoundingSphere(box);
}

void TilePager::seasonChanged() {
    if (_crowns)
        _crowns->showSeason(_simulation->season());
}

void TilePager::traverse(osg::NodeVisitor& visitor) {
    osg::Group::traverse(visitor);
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR && visitor.getFrameStamp())
        _guard.run("tiles of the forest may be missing", [&] { requestTiles(visitor); });
}

void TilePager::requestTiles(osg::NodeVisitor& visitor) {
    const osg::Vec3 local = visitor.getViewPoint();
    const glm::dvec3 eye(local.x(), local.y(), local.z());
    const double range = _tiles.range;
    const glm::dvec2 reach(keepRangeFactor * range), middle = glm::dvec2(eye + _origin) - _tiles.corner,
                                                     last(_tiles.columns - 1.0, _tiles.rows() - 1.0);
    const glm::dvec2 low = glm::max(glm::floor((middle - reach) / _tiles.size), glm::dvec2(0.0)),
                     high = glm::min(glm::floor((middle + reach) / _tiles.size), last);
    const std::lock_guard<std::mutex> lock(_mutex);
    _eye = eye;
    if (!_crownFile.isLoaded && _crownFile.requestNode->getNumChildren() == 0)
        requestFile(_crownFile, fileOfCrowns(_tiles), 1.0f, visitor);
    for (double row = low.y; row <= high.y; ++row)
        for (double column = low.x; column <= high.x; ++column) {
            const std::size_t tile =
                static_cast<std::size_t>(row) * _tiles.columns + static_cast<std::size_t>(column);
            const double distance = distanceTo(tile, eye);
            const auto found = _slots.find(tile);
            if (_tiles.tiles[tile].trees == 0 ||
                distance > (found == _slots.end() ? 1.0 : keepRangeFactor) * range)
                continue;
            Slot& slot = _slots[tile];
            const unsigned frame = visitor.getFrameStamp()->getFrameNumber();
            slot.distance = slot.nearFrame == frame ? std::min(slot.distance, distance) : distance;
            slot.nearFrame = frame;
            slot.nearTime = visitor.getFrameStamp()->getReferenceTime();
            if (!slot.isLoaded && slot.requestNode->getNumChildren() == 0)
                requestFile(slot, fileOfTile(_tiles, tile),
                            static_cast<float>(1.0 - distance / (keepRangeFactor * range)), visitor);
        }
}

/// Renews the request in each frame, as pagers drop old ones. If the pager released a request that was
/// renewed in the last frame, it could not read the file.
void TilePager::requestFile(Slot& slot, const std::string& file, float priority, osg::NodeVisitor& visitor) {
    osg::NodeVisitor::DatabaseRequestHandler* pager = visitor.getDatabaseRequestHandler();
    const osg::FrameStamp& stamp = *visitor.getFrameStamp();
    if (!pager) {
        if (!_hasWarnedOfPager)
            OSG_WARN << "osgTreeWind: the tiles of a forest need a viewer with a pager "
                        "(osgUtil::CullVisitor::setDatabaseRequestHandler())"
                     << std::endl;
        _hasWarnedOfPager = true;
        return;
    }
    if (stamp.getReferenceTime() < slot.retryTime)
        return;
    if (slot.request.valid() && slot.request->referenceCount() == 1 &&
        slot.requestFrame + 1 >= stamp.getFrameNumber() && slot.requestFrame != stamp.getFrameNumber())
        return scheduleRetry(slot, stamp.getReferenceTime());
    slot.requestFrame = stamp.getFrameNumber();
    osg::NodePath path = {slot.requestNode.get()};
    pager->requestNodeFile(file, path, priority, &stamp, slot.request, _options.get());
}

void TilePager::scheduleRetry(Slot& slot, double now) const {
    slot.request = nullptr;
    slot.retryDelay = std::clamp(2.0 * slot.retryDelay, minRetryDelay, maxRetryDelay);
    slot.retryTime = now + slot.retryDelay;
}

void TilePager::receiveTile(Slot& slot, std::size_t tile, const osg::ref_ptr<osg::Node>& file, double now) {
    auto* arrived = dynamic_cast<TreeTile*>(file.get());
    slot.requestNode = new osg::Group;
    Diagnostics problems = {fileProblem(fileOfTile(_tiles, tile), "expected trees")};
    if (arrived)
        problems = arrived->content.resolve(_simulation->description().species, _tiles.tiles[tile].trees,
                                            fileOfTile(_tiles, tile));
    if (!problems.empty()) {
        if (_warnedTiles.insert(tile).second)
            OSG_WARN << "osgTreeWind: " << problems.front().text() << "; its area stays empty" << std::endl;
        return scheduleRetry(slot, now);
    }
    slot.request = nullptr;
    slot.isLoaded = true;
    slot.pendingTrees = std::move(arrived->content.trees);
    std::reverse(slot.pendingTrees.begin(), slot.pendingTrees.end());
}

void TilePager::receiveCrowns(double now) {
    const osg::ref_ptr<CrownFile> arrived = dynamic_cast<CrownFile*>(_crownFile.requestNode->getChild(0));
    _crownFile.requestNode = new osg::Group;
    if (!arrived)
        return scheduleRetry(_crownFile, now);
    _crownFile.isLoaded = true;
    _crowns = new FarCrowns(arrived->content, _simulation->description());
    _crowns->showSeason(_simulation->season());
    addChild(_crowns);
    for (const auto& [tile, slot] : _slots)
        _crowns->setTileVisible(tile, !slot.isLoaded || !slot.pendingTrees.empty());
}

/// @param until end of the time budget on the clock of osg::Timer, seconds.
void TilePager::addPendingTrees(Slot& slot, double until, std::vector<TreeId>& addedNearEye) const {
    const std::set<std::string>& removed = movingForest(*_simulation).placed().removedPermanently();
    while (!slot.pendingTrees.empty() && osg::Timer::instance()->time_s() < until) {
        TreePlacement& tree = slot.pendingTrees.back();
        tree.tiled = true;
        const bool isWanted = removed.count(tree.name) == 0 && _damagedTrees.count(tree.name) == 0;
        if (const std::optional<TreeId> id = isWanted ? _addTree(tree) : std::nullopt) {
            slot.loadedTrees.push_back(*id);
            if (glm::distance(tree.position - _origin, _eye) < visibleSwayDistance)
                addedNearEye.push_back(*id);
        }
        slot.pendingTrees.pop_back();
    }
}

/// Keeps trees that the wind has broken, as the tile would bring them back unbroken.
void TilePager::collectTreesToUnload(Slot& slot, std::vector<TreeId>& toUnload) {
    for (const TreeId tree : slot.loadedTrees) {
        const std::size_t treeSlot = slotOfTree(tree);
        if (!_simulation->holds(tree) || !movingForest(*_simulation).trees()[treeSlot].tiled)
            continue; // the host changed it, so that it belongs to the forest now
        if (movingForest(*_simulation).modal()->fall(treeSlot))
            _damagedTrees.insert(_simulation->nameOf(tree));
        else
            toUnload.push_back(tree);
    }
}

std::optional<std::size_t> TilePager::findTile(const std::string& name) const {
    if (const std::optional<std::size_t> tile = tileOfPlace(_tiles, name))
        return tile;
    const std::optional<std::uint32_t> number = idFileOf(_tiles, name);
    if (!number)
        return {};
    const std::string file = fileOfIds(_tiles, *number);
    const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(file, _options.get());
    const auto* ids = dynamic_cast<const IdFile*>(read.get());
    if (!ids) {
        OSG_WARN << "osgTreeWind: " << file << ": expected tree ids; trees cannot be found by their ids"
                 << std::endl;
        return {};
    }
    const auto place = ids->content.find(name);
    return place == ids->content.end() ? std::nullopt : tileOfPlace(_tiles, place->second);
}

void TilePager::loadTree(const std::string& name) {
    const std::optional<std::size_t> tile = findTile(name);
    if (!tile || _tiles.tiles[*tile].trees == 0)
        return;
    std::unique_lock<std::mutex> lock(_mutex);
    if (movingForest(*_simulation).placed().removedPermanently().count(name) > 0)
        return;
    osg::ref_ptr<osg::Node> fetched;
    if (const auto known = _slots.find(*tile); known == _slots.end() || !known->second.isLoaded) {
        lock.unlock(); // a server may be slow
        fetched = osgDB::readRefNodeFile(fileOfTile(_tiles, *tile), _options.get());
        lock.lock();
    }
    Slot& slot = _slots[*tile];
    slot.nearFrame = _frame;
    slot.nearTime = _now;
    if (!slot.isLoaded)
        receiveTile(slot, *tile, fetched, _now);
    std::vector<TreeId> addedNearEye;
    addPendingTrees(slot, std::numeric_limits<double>::infinity(), addedNearEye);
    if (_crowns && slot.isLoaded)
        _crowns->setTileVisible(*tile, false);
}

TilePager::Changes TilePager::update(const osg::FrameStamp& stamp) {
    const std::lock_guard<std::mutex> lock(_mutex);
    const double now = _now = stamp.getReferenceTime();
    _frame = stamp.getFrameNumber();
    Changes changes;
    if (_crownFile.requestNode->getNumChildren() > 0)
        receiveCrowns(now);
    std::vector<std::pair<std::size_t, Slot*>> pendingTrees;
    for (auto next = _slots.begin(); next != _slots.end();) {
        auto& [tile, slot] = *next;
        if (stamp.getFrameNumber() > slot.nearFrame + keepFrames && now > slot.nearTime + keepTime) {
            collectTreesToUnload(slot, changes.toUnload);
            if (_crowns)
                _crowns->setTileVisible(tile, true);
            next = _slots.erase(next);
            continue;
        }
        if (slot.requestNode->getNumChildren() > 0)
            receiveTile(slot, tile, slot.requestNode->getChild(0), now);
        if (!slot.pendingTrees.empty())
            pendingTrees.emplace_back(tile, &slot);
        ++next;
    }
    std::sort(pendingTrees.begin(), pendingTrees.end(),
              [](const auto& a, const auto& b) { return a.second->distance < b.second->distance; });
    const double time = osg::Timer::instance()->time_s(),
                 share = _wasComplete ? 0.25 : 1.0, // at first, completeness matters more than frame rate
        until = time + std::clamp(share * (time - _lastUpdate), minLoadTime, maxLoadTime);
    _lastUpdate = time;
    for (auto& [tile, slot] : pendingTrees) {
        addPendingTrees(*slot, until, changes.addedNearEye);
        if (_crowns && slot->pendingTrees.empty())
            _crowns->setTileVisible(tile, false);
    }
    _wasComplete = _wasComplete || (!_slots.empty() && !std::isfinite(findNearestMissing()));
    return changes;
}

double TilePager::nearestMissingDistance() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return findNearestMissing();
}

std::size_t TilePager::loadedTileCount() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return static_cast<std::size_t>(std::count_if(_slots.begin(), _slots.end(), [](const auto& slot) {
        return slot.second.isLoaded && slot.second.pendingTrees.empty();
    }));
}

double TilePager::findNearestMissing() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [tile, slot] : _slots)
        if (!slot.pendingTrees.empty() || (!slot.isLoaded && slot.retryDelay == 0.0))
            nearest = std::min(nearest, slot.distance);
    return nearest;
}

} // namespace osgTreeWind
