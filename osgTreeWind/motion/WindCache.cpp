// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindCache.h>

#include <osgTreeWind/wind/WindKeys.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Whether two mean winds differ so little that the trees' surroundings stay valid.
bool areSimilar(const glm::vec3& wind, const glm::vec3& other) {
    return glm::distance(wind, other) <= 0.1f * glm::length(other);
}

} // namespace

void WindCache::setCanopy(const CanopySettings& canopy) {
    if (areKeysEqual(canopy, _settings))
        return;
    _settings = canopy;
    _meanStand = CanopyCell();
    _map = nullptr;
    _flow = nullptr;
}

void WindCache::setForestToScene(const glm::dmat4& forestToScene) {
    if (forestToScene == _forestToScene)
        return;
    _forestToScene = forestToScene;
    _openWind = _treesWind = nullptr;
}

void WindCache::treeChanged(std::size_t slot) {
    if (slot < _trees.size())
        _trees[slot].reset();
    _changed = true;
}

void WindCache::allTreesChanged() {
    _trees.clear();
    _changed = true;
}

void WindCache::reset() {
    const glm::dmat4 place = _forestToScene;
    *this = WindCache(_settings);
    _forestToScene = place;
}

void WindCache::rebuildMap(const PlacedForest& forest) {
    _trees.resize(forest.trees.size());
    std::vector<CanopyTree> alive;
    alive.reserve(_trees.size());
    for (std::size_t slot = 0; slot < _trees.size(); ++slot) {
        const PlacedTree& tree = forest.trees[slot];
        if (!tree.alive)
            continue;
        if (!_trees[slot])
            _trees[slot].emplace(forest, tree);
        alive.push_back(*_trees[slot]);
    }
    const std::shared_ptr<CanopyMap> made = makeCanopyMap(alive, _settings);
    if (_meanStand.closure > 0.0f) {
        made->usual = _meanStand;
        made->extent = _extent;
    }
    _meanStand = made->usual;
    _extent = made->extent;
    made->setReference(static_cast<float>(_settings.reference));
    _map = made;
    _flow = nullptr;
    _treesWind = nullptr;
}

WindFieldPtr WindCache::openField(const std::shared_ptr<const Wind>& wind) {
    if (wind != _openWind) {
        _openWind = wind;
        _open = LayeredWind(wind, _forestToScene).top();
    }
    return _open;
}

WindFieldPtr WindCache::fieldAtTrees(const std::shared_ptr<const Wind>& wind, const PlacedForest& forest,
                                     double time) {
    if (!wind->field || _settings.source == CanopySource::None)
        return openField(wind);
    const bool isTooSoon = forest.description().tiles && std::abs(time - _rebuildTime) < rebuildInterval;
    if (!_map || (_changed && !isTooSoon)) {
        rebuildMap(forest);
        _changed = false;
        _rebuildTime = time;
    }
    if (wind != _treesWind) {
        _treesWind = wind;
        const LayeredWind sampler(wind, _forestToScene, _map, _settings.seed);
        _atTrees = sampler.top();
        if (!(_flow && areSimilar(sampler.canopy()->meanWind(), _flow->meanWind())))
            _flow = sampler.canopy();
    }
    return _atTrees;
}

} // namespace osgTreeWind
