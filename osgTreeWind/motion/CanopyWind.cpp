// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/CanopyWind.h>

#include <osgTreeWind/wind/WindFields.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Whether two mean winds differ so little that the trees' surroundings stay valid.
bool areSimilar(const glm::vec3& wind, const glm::vec3& other) {
    return glm::distance(wind, other) <= 0.1f * glm::length(other);
}

} // namespace

void CanopyWind::treeChanged(std::size_t slot) {
    if (slot < _trees.size())
        _trees[slot].reset();
    _changed = true;
}

void CanopyWind::allTreesChanged() {
    _trees.clear();
    _changed = true;
}

void CanopyWind::reset() {
    *this = CanopyWind();
}

std::shared_ptr<CanopyMap> CanopyWind::buildCanopy(const PlacedForest& forest) {
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
    return makeCanopy(alive, _settings);
}

WindFieldPtr CanopyWind::update(HostWind& host, const PlacedForest& forest, double time) {
    const std::shared_ptr<const Wind> wind = host.get();
    const WindCanopy settings = wind->canopy.value_or(WindCanopy());
    if (!wind->field || settings.source == CanopySource::None)
        return host.fieldWithoutTrees();
    const bool settingsChanged = !areFieldsEqual(settings, _settings);
    if (settingsChanged) {
        _settings = settings;
        _meanStand = CanopyCell();
    }
    const bool isTooSoon = forest.description().tiles && std::abs(time - _rebuildTime) < rebuildInterval;
    if (!_canopy || settingsChanged || (_changed && !isTooSoon)) {
        const std::shared_ptr<CanopyMap> made = buildCanopy(forest);
        if (_meanStand.closure > 0.0f)
            made->usual = _meanStand;
        _meanStand = made->usual;
        made->setReference(static_cast<float>(settings.reference));
        _canopy = made;
        _changed = false;
        _rebuildTime = time;
        _wind = nullptr;
        _flow = nullptr;
    }
    if (wind == _wind && host.forestToScene() == _forestToScene)
        return _sampler;
    _wind = wind;
    _forestToScene = host.forestToScene();
    _sampler = std::make_shared<WindSampler>(wind, _forestToScene, _canopy);
    if (!(_flow && areSimilar(_sampler->canopy()->meanWind(), _flow->meanWind())))
        _flow = _sampler->canopy();
    return _sampler;
}

} // namespace osgTreeWind
