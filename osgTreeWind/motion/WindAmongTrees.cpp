// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindAmongTrees.h>

#include <osgTreeWind/wind/WindFields.h>

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

std::shared_ptr<CanopyMap> WindAmongTrees::canopyOfForest(const PlacedForest& forest) {
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
    return canopyOf(alive, _asked);
}

WindFieldPtr WindAmongTrees::from(GivenWind& given, const PlacedForest& forest, double time) {
    const std::shared_ptr<const Wind> wind = given.get();
    const WindCanopy asked = wind->canopy.value_or(WindCanopy());
    if (!wind->field || asked.source == CanopySource::None)
        return given.here();
    const bool asksAnew = !sameFields(asked, _asked);
    if (asksAnew) {
        _asked = asked;
        _usual = CanopyCell();
    }
    const bool waits = forest.description().tiles && std::abs(time - _madeAt) < patience;
    if (!_canopy || asksAnew || (_changed && !waits)) {
        const std::shared_ptr<CanopyMap> made = canopyOfForest(forest);
        if (_usual.closure > 0.0f)
            made->usual = _usual;
        _usual = made->usual;
        made->refer(static_cast<float>(asked.reference));
        _canopy = made;
        _changed = false;
        _madeAt = time;
        _given = nullptr;
        _company = nullptr;
    }
    if (wind == _given && given.place() == _place)
        return _met;
    _given = wind;
    _place = given.place();
    _met = std::make_shared<WindSampler>(wind, _place, _canopy);
    if (!(_company && near(_met->canopy()->meanWind(), _company->meanWind())))
        _company = _met->canopy();
    return _met;
}

} // namespace osgTreeWind
