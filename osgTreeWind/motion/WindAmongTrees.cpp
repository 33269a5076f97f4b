// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindAmongTrees.h>

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
    std::vector<CanopyTree> alive;
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
    const auto continueDown = [&](const WindFieldPtr& open) -> WindFieldPtr {
        if (!open)
            return nullptr;
        const auto among =
            std::make_shared<CanopyWind>(open, *_canopy, static_cast<float>(canopy.reference), canopy.seed);
        if (!(_company && near(among->meanWind(), _company->meanWind())))
            _company = among;
        return among;
    };
    // Sources move the air among the trees as above them.
    _met = given->changedBesideSources(continueDown);
    if (!_met)
        _met = continueDown(given);
    _given = given;
    return _met;
}

} // namespace osgTreeWind
