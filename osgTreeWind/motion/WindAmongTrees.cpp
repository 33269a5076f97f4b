// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindAmongTrees.h>

#include <osgTreeWind/wind/WindWithSources.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Company is much the same in both.
bool near(const glm::vec3& wind, const glm::vec3& other) {
    return glm::distance(wind, other) <= 0.1f * glm::length(other);
}

} // namespace

void WindAmongTrees::treeChanged(std::size_t slot) {
    if (slot < _trees.size())
        _trees[slot].reset();
    _changed = true;
}

void WindAmongTrees::allTreesChanged() {
    _trees.clear();
    _changed = true;
}

void WindAmongTrees::reset() {
    *this = WindAmongTrees();
}

std::shared_ptr<const CanopyMap> WindAmongTrees::canopyOfForest(const PlacedForest& forest) {
    _trees.resize(forest.trees.size());
    std::vector<StandTree> alive;
    alive.reserve(_trees.size());
    for (std::size_t slot = 0; slot < _trees.size(); ++slot) {
        const PlacedTree& tree = forest.trees[slot];
        if (!tree.alive)
            continue;
        if (!_trees[slot])
            _trees[slot].emplace(forest.modelOf(tree), tree.scale, forest.speciesOf(tree), tree.leaves,
                                 glm::vec2(tree.position));
        alive.push_back(*_trees[slot]);
    }
    return canopyOf(alive, forest.description().windCanopy);
}

WindFieldPtr WindAmongTrees::from(const WindFieldPtr& given, const PlacedForest& forest, double time) {
    const WindCanopy& canopy = forest.description().windCanopy;
    if (!given || canopy.source == CanopySource::None)
        return given;
    const bool waits = forest.description().tiles && std::abs(time - _madeAt) < patience;
    if (!_canopy || (_changed && !waits)) {
        const auto made = std::make_shared<CanopyMap>(*canopyOfForest(forest));
        if (_usual.closure > 0.0f)
            made->usual = _usual;
        _usual = made->usual;
        _canopy = made;
        _changed = false;
        _madeAt = time;
        _given = nullptr;
        _company = nullptr;
    }
    if (given == _given)
        return _met;
    // What moves the air beside the wind does so among the trees as above them.
    const auto sourced = std::dynamic_pointer_cast<const WindWithSources>(given);
    const WindFieldPtr& open = sourced ? sourced->wind() : given;
    const auto among =
        open ? std::make_shared<CanopyWind>(open, *_canopy, static_cast<float>(canopy.reference), canopy.seed)
             : nullptr;
    if (among && !(_company && near(among->meanWind(), _company->meanWind())))
        _company = among;
    _met = among;
    if (sourced)
        _met = std::make_shared<WindWithSources>(_met, sourced->sources());
    _given = given;
    return _met;
}

} // namespace osgTreeWind
