// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TilePager.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/drawing/crowns/FarCrowns.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
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

constexpr double keptFrom = 1.2;    // of the range: how far one may go from a tile that is there
constexpr double keptFor = 5.0;     // seconds that a tile outlasts being near,
constexpr unsigned keptFrames = 60; // and frames
constexpr double shortestWait = 2.0, longestWait = 60.0;   // seconds until a tile is tried again
constexpr double shortestWork = 0.002, longestWork = 0.25; // seconds of an update for what has arrived
constexpr double seenFrom = 300.0;                         // metres: how a tree sways
constexpr double tallest = 50.0;                           // metres: trees reach that far above their feet

/// The program's own options. Where they do not limit the time of a server, it has 10 s for a connection and
/// 60 s for a file; OpenSceneGraph would wait for ever.
osg::ref_ptr<osgDB::Options> patientOptions() {
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
      _options(patientOptions()) {
    registerTileReader();
}

TilePager::~TilePager() = default;

/// From an eye in the forest's frame, metres.
double TilePager::distanceTo(std::size_t tile, const glm::dvec3& eye) const {
    const glm::dvec2 corner = _tiles.cornerOf(tile);
    const double low = static_cast<double>(_tiles.tiles[tile].low),
                 high = static_cast<double>(_tiles.tiles[tile].high) + tallest;
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
        box.expandBy(toOsg(
            glm::vec3(glm::dvec3(corner + _tiles.size, static_cast<double>(tile.high) + tallest) - _origin)));
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
        _guard.run("tiles of the forest may not come", [&] { askForTiles(visitor); });
}

void TilePager::askForTiles(osg::NodeVisitor& visitor) {
    const osg::Vec3 local = visitor.getViewPoint();
    const glm::dvec3 eye(local.x(), local.y(), local.z());
    const double range = _tiles.range;
    const glm::dvec2 reach(keptFrom * range), middle = glm::dvec2(eye + _origin) - _tiles.corner,
                                              last(_tiles.columns - 1.0, _tiles.rows() - 1.0);
    const glm::dvec2 low = glm::max(glm::floor((middle - reach) / _tiles.size), glm::dvec2(0.0)),
                     high = glm::min(glm::floor((middle + reach) / _tiles.size), last);
    const std::lock_guard<std::mutex> lock(_mutex);
    _eye = eye;
    if (!_crownFile.arrived && _crownFile.arrival->getNumChildren() == 0)
        ask(_crownFile, fileOfCrowns(_tiles), 1.0f, visitor);
    for (double row = low.y; row <= high.y; ++row)
        for (double column = low.x; column <= high.x; ++column) {
            const std::size_t tile =
                static_cast<std::size_t>(row) * _tiles.columns + static_cast<std::size_t>(column);
            const double distance = distanceTo(tile, eye);
            const auto found = _slots.find(tile);
            if (_tiles.tiles[tile].trees == 0 || distance > (found == _slots.end() ? 1.0 : keptFrom) * range)
                continue;
            Slot& slot = _slots[tile];
            const unsigned frame = visitor.getFrameStamp()->getFrameNumber();
            slot.distance = slot.near == frame ? std::min(slot.distance, distance) : distance;
            slot.near = frame;
            slot.nearTime = visitor.getFrameStamp()->getReferenceTime();
            if (!slot.arrived && slot.arrival->getNumChildren() == 0)
                ask(slot, fileOfTile(_tiles, tile), static_cast<float>(1.0 - distance / (keptFrom * range)),
                    visitor);
        }
}

/// Asks in each frame, as pagers forget; one that lets go of a request that was renewed has failed.
void TilePager::ask(Slot& slot, const std::string& file, float priority, osg::NodeVisitor& visitor) {
    osg::NodeVisitor::DatabaseRequestHandler* pager = visitor.getDatabaseRequestHandler();
    const osg::FrameStamp& stamp = *visitor.getFrameStamp();
    if (!pager) {
        if (!_pagerless)
            OSG_WARN << "osgTreeWind: the tiles of a forest need a viewer with a pager "
                        "(osgUtil::CullVisitor::setDatabaseRequestHandler())"
                     << std::endl;
        _pagerless = true;
        return;
    }
    if (stamp.getReferenceTime() < slot.nextTry)
        return;
    if (slot.request.valid() && slot.request->referenceCount() == 1 &&
        slot.asked + 1 >= stamp.getFrameNumber() && slot.asked != stamp.getFrameNumber())
        return failed(slot, stamp.getReferenceTime());
    slot.asked = stamp.getFrameNumber();
    osg::NodePath path = {slot.arrival.get()};
    pager->requestNodeFile(file, path, priority, &stamp, slot.request, _options.get());
}

void TilePager::failed(Slot& slot, double now) const {
    slot.request = nullptr;
    slot.wait = std::clamp(2.0 * slot.wait, shortestWait, longestWait);
    slot.nextTry = now + slot.wait;
}

void TilePager::receive(Slot& slot, std::size_t tile, const osg::ref_ptr<osg::Node>& file, double now) {
    auto* arrived = dynamic_cast<TreeTile*>(file.get());
    slot.arrival = new osg::Group;
    Diagnostics problems = {fileProblem(fileOfTile(_tiles, tile), "expected trees")};
    if (arrived)
        problems = arrived->content.fit(_simulation->description().species, _tiles.tiles[tile].trees,
                                        fileOfTile(_tiles, tile));
    if (!problems.empty()) {
        if (_blamed.insert(tile).second)
            OSG_WARN << "osgTreeWind: " << problems.front().text() << "; its place stays empty" << std::endl;
        return failed(slot, now);
    }
    slot.request = nullptr;
    slot.arrived = true;
    slot.coming = std::move(arrived->content.trees);
    std::reverse(slot.coming.begin(), slot.coming.end());
}

void TilePager::receiveCrowns(double now) {
    const osg::ref_ptr<CrownFile> arrived = dynamic_cast<CrownFile*>(_crownFile.arrival->getChild(0));
    _crownFile.arrival = new osg::Group;
    if (!arrived)
        return failed(_crownFile, now);
    _crownFile.arrived = true;
    _crowns = new FarCrowns(arrived->content, _simulation->description());
    _crowns->showSeason(_simulation->season());
    addChild(_crowns);
    for (const auto& [tile, slot] : _slots)
        _crowns->show(tile, !slot.arrived || !slot.coming.empty());
}

/// @param until as osg::Timer::time_s() has it.
void TilePager::putUp(Slot& slot, double until, std::vector<TreeId>& near) const {
    const std::set<std::string>& removed = SimulationParts::forest(*_simulation).struck();
    while (!slot.coming.empty() && osg::Timer::instance()->time_s() < until) {
        TreePlacement& tree = slot.coming.back();
        tree.tiled = true;
        const bool comes = removed.count(tree.name) == 0 && _damaged.count(tree.name) == 0;
        if (const TreeId id = comes ? _addTree(tree) : noTree; id != noTree) {
            slot.standing.push_back(id);
            if (glm::distance(tree.position - _origin, _eye) < seenFrom)
                near.push_back(id);
        }
        slot.coming.pop_back();
    }
}

/// All but those that wind has damaged: they would come again unharmed.
void TilePager::leave(Slot& slot, std::vector<TreeId>& leaving) {
    for (const TreeId tree : slot.standing) {
        const std::size_t number = _simulation->slotOf(tree);
        if (!_simulation->holds(tree) || !SimulationParts::trees(*_simulation)[number].tiled)
            continue; // its host made it another one
        if (SimulationParts::modal(*_simulation)->fall(number))
            _damaged.insert(_simulation->nameOf(tree));
        else
            leaving.push_back(tree);
    }
}

std::optional<std::size_t> TilePager::tileWith(const std::string& name) const {
    if (const std::optional<std::size_t> tile = tileOfPlace(_tiles, name))
        return tile;
    const std::optional<std::uint32_t> number = idFileOf(_tiles, name);
    if (!number)
        return {};
    const std::string file = fileOfIds(_tiles, *number);
    const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(file, _options.get());
    const auto* ids = dynamic_cast<const IdFile*>(read.get());
    if (!ids) {
        OSG_WARN << "osgTreeWind: " << file << ": expected ids; no tree is found by one of them" << std::endl;
        return {};
    }
    const auto place = ids->content.find(name);
    return place == ids->content.end() ? std::nullopt : tileOfPlace(_tiles, place->second);
}

void TilePager::bring(const std::string& name) {
    const std::optional<std::size_t> tile = tileWith(name);
    if (!tile || _tiles.tiles[*tile].trees == 0)
        return;
    std::unique_lock<std::mutex> lock(_mutex);
    if (SimulationParts::forest(*_simulation).struck().count(name) > 0)
        return;
    osg::ref_ptr<osg::Node> fetched;
    if (const auto known = _slots.find(*tile); known == _slots.end() || !known->second.arrived) {
        lock.unlock(); // a server may take its time
        fetched = osgDB::readRefNodeFile(fileOfTile(_tiles, *tile), _options.get());
        lock.lock();
    }
    Slot& slot = _slots[*tile];
    slot.near = _frame;
    slot.nearTime = _now;
    if (!slot.arrived)
        receive(slot, *tile, fetched, _now);
    std::vector<TreeId> near;
    putUp(slot, std::numeric_limits<double>::infinity(), near);
    if (_crowns && slot.arrived)
        _crowns->show(*tile, false);
}

TilePager::Changes TilePager::update(const osg::FrameStamp& stamp) {
    const std::lock_guard<std::mutex> lock(_mutex);
    const double now = _now = stamp.getReferenceTime();
    _frame = stamp.getFrameNumber();
    Changes changes;
    if (_crownFile.arrival->getNumChildren() > 0)
        receiveCrowns(now);
    std::vector<std::pair<std::size_t, Slot*>> coming;
    for (auto next = _slots.begin(); next != _slots.end();) {
        auto& [tile, slot] = *next;
        if (stamp.getFrameNumber() > slot.near + keptFrames && now > slot.nearTime + keptFor) {
            leave(slot, changes.leaving);
            if (_crowns)
                _crowns->show(tile, true);
            next = _slots.erase(next);
            continue;
        }
        if (slot.arrival->getNumChildren() > 0)
            receive(slot, tile, slot.arrival->getChild(0), now);
        if (!slot.coming.empty())
            coming.emplace_back(tile, &slot);
        ++next;
    }
    std::sort(coming.begin(), coming.end(),
              [](const auto& a, const auto& b) { return a.second->distance < b.second->distance; });
    const double time = osg::Timer::instance()->time_s(),
                 share = _wasWhole ? 0.25 : 1.0, // nobody has seen a steady picture before
        until = time + std::clamp(share * (time - _updated), shortestWork, longestWork);
    _updated = time;
    for (auto& [tile, slot] : coming) {
        putUp(*slot, until, changes.near);
        if (_crowns && slot->coming.empty())
            _crowns->show(tile, false);
    }
    _wasWhole = _wasWhole || (!_slots.empty() && !std::isfinite(nearest()));
    return changes;
}

double TilePager::nearestMissing() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return nearest();
}

std::size_t TilePager::countThere() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return static_cast<std::size_t>(std::count_if(_slots.begin(), _slots.end(), [](const auto& slot) {
        return slot.second.arrived && slot.second.coming.empty();
    }));
}

double TilePager::nearest() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [tile, slot] : _slots)
        if (!slot.coming.empty() || (!slot.arrived && slot.wait == 0.0))
            nearest = std::min(nearest, slot.distance);
    return nearest;
}

} // namespace osgTreeWind
