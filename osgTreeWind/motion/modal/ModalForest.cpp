// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalForest.h>

#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>
#include <osgTreeWind/motion/laws/UnitPose.h>
#include <osgTreeWind/wind/CanopyFlow.h>

#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double maxWindInterval = 0.1 + 1e-6; // seconds between samples of the wind

} // namespace

ModalForest::ModalForest(const PlacedForest& forest, ModalLevel level, bool leaves, Executor executor)
    : _forest(forest), _level(level), _withLeaves(leaves),
      _sway(makeModalTrees(), forest.description().gain, std::move(executor)) {}

ModalForest::ModalForest(const ModalForest& other, const PlacedForest& forest)
    : _forest(forest), _level(other._level), _withLeaves(other._withLeaves), _sway(other._sway),
      _nextLeafUpdate(other._nextLeafUpdate) {
    _sway.reset();
}

std::unique_ptr<Motion> ModalForest::cloneAtRest(const PlacedForest& forest) const {
    return std::unique_ptr<Motion>(new ModalForest(*this, forest));
}

std::vector<ModalTree> ModalForest::makeModalTrees() const {
    std::vector<ModalTree> trees;
    trees.reserve(_forest.trees.size());
    for (const PlacedTree& tree : _forest.trees)
        trees.push_back(makeModalTree(_forest, tree, _level));
    return trees;
}

void ModalForest::sampleWind(const WindField* wind, double time) {
    _time = time;
    _sway.sampleWind(wind, time);
}

void ModalForest::step(const WindField* wind, double time, float seconds) {
    _time = time;
    if (_nextLeafUpdate < _forest.trees.size())
        updateNextLeaves();
    const auto elapsed = static_cast<double>(seconds);
    const int parts = static_cast<int>(std::ceil(elapsed / maxWindInterval));
    for (int part = parts - 1; part >= 0; --part)
        _sway.step(wind, time - elapsed * part / parts, static_cast<float>(elapsed / parts));
}

void ModalForest::reset() {
    _time = 0.0;
    _sway.reset();
}

void ModalForest::setCanopyFlow(const CanopyFlow& wind) {
    for (std::size_t slot = 0; slot < _forest.trees.size(); ++slot)
        if (_sway.holds(slot))
            _sway.setNeighbourEffect(slot, wind.neighbourEffectAt(glm::vec2(_forest.trees[slot].position)));
}

void ModalForest::updateAllLeaves() {
    _nextLeafUpdate = 0;
    updateNextLeaves();
}

void ModalForest::updateNextLeaves() {
    std::vector<std::size_t> slots;
    std::vector<ModalTree> wanted;
    for (; _nextLeafUpdate < _forest.trees.size() && slots.size() < leafUpdatesPerStep; ++_nextLeafUpdate)
        if (_forest.trees[_nextLeafUpdate].alive) {
            slots.push_back(_nextLeafUpdate);
            wanted.push_back(makeModalTree(_forest, _forest.trees[_nextLeafUpdate], _level));
        }
    const std::size_t ready = _sway.makeArchetypesFor(wanted, newArchetypesPerStep);
    for (std::size_t i = 0; i < ready; ++i)
        _sway.replace(slots[i], wanted[i]);
    if (ready < slots.size())
        _nextLeafUpdate = slots[ready];
}

void ModalForest::updateLeaves(const std::vector<std::size_t>& slots) {
    for (const std::size_t slot : slots)
        _sway.replace(slot, makeModalTree(_forest, _forest.trees[slot], _level));
}

void ModalForest::remove(std::size_t slot) {
    _sway.remove(slot);
    _values.erase(slot);
}

UnitValues& ModalForest::valuesOf(std::size_t slot) const {
    const std::lock_guard<std::mutex> lock(_valuesMutex);
    return _values[slot];
}

TreeMotion ModalForest::motion(std::size_t slot) const {
    return _sway.holds(slot) ? motion(slot, valuesOf(slot)) : TreeMotion();
}

TreeMotion ModalForest::motion(std::size_t slot, UnitValues& values) const {
    if (!_sway.holds(slot))
        return {};
    const PlacedTree& tree = _forest.trees[slot];
    const Skeleton& skeleton = _forest.modelOf(tree).skeleton;
    const std::size_t units = skeleton.units.size();
    values.resize(units, _withLeaves ? _forest.leafCount(tree) : 0);
    _sway.angles(slot, values.angles.data());
    _sway.winds(slot, values.winds.data());
    for (std::size_t i = 0; i < units; ++i)
        values.states[i] = glm::vec4(values.angles[i], 0.0f, 0.0f);
    composeModalPoses(skeleton, tree.scale, values.angles.data(), values.rotations.data(),
                      values.poses.data());
    if (const TreeFall* fall = _sway.fall(slot)) {
        for (std::size_t unit = 0; unit < units; ++unit)
            values.rotations[unit] = fall->turned(unit, values.rotations[unit]);
        composePoses(skeleton, tree.scale, values.rotations.data(), values.poses.data());
    }
    if (_withLeaves) {
        pull(slot, values);
        flutter(tree, values);
    }
    return {{values.poses.data(), units},
            {values.rotations.data(), units},
            {values.states.data(), units},
            {values.winds.data(), units},
            {values.leaves.data(), values.leaves.size()},
            {values.pulls.data(), _withLeaves ? units : 0}};
}

UnitMotion ModalForest::unitMotion(std::size_t slot, std::size_t unit) const {
    const PlacedTree& tree = _forest.trees[slot];
    const std::vector<BranchUnit>& units = _forest.modelOf(tree).skeleton.units;
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    _sway.poseVector(slot, vector);
    const TreeFall* fall = _sway.fall(slot);
    const auto motionOf = [&](const auto& self, std::size_t at) -> UnitMotion {
        const int parent = units[at].parent;
        const UnitPose carrier = parent < 0 ? UnitPose() : self(self, static_cast<std::size_t>(parent)).pose;
        glm::quat rotation = swungRotation(units[at], tree.scale, _sway.unitAngles(slot, at, vector));
        if (fall)
            rotation = fall->turned(at, rotation);
        return {childPose(carrier, rotation, tree.scale.axes * units[at].base), rotation};
    };
    return motionOf(motionOf, unit);
}

void ModalForest::pull(std::size_t slot, UnitValues& values) const {
    const Reconfiguration foliage(_forest.speciesOf(_forest.trees[slot]));
    glm::vec3 winds[ModalDetail::maxPatches];
    _sway.patchWinds(slot, winds);
    const std::vector<std::size_t>& patches = _sway.model(slot).patchOfLink;
    for (std::size_t unit = 0; unit < patches.size(); ++unit) {
        const glm::vec4 pull = foliage.pull(winds[patches[unit]]);
        values.pulls[unit] = glm::vec4(glm::conjugate(values.poses[unit].rotation) * glm::vec3(pull), pull.w);
    }
}

void ModalForest::flutter(const PlacedTree& tree, UnitValues& values) const {
    const std::vector<LeafCluster>& leaves = _forest.modelOf(tree).leaves;
    const LeafMotion& leaf = _forest.speciesOf(tree).leaf;
    StatelessFlutter{{leaves.data(), leaves.size()},
                     tree.scale.axes,
                     {values.winds.data(), values.winds.size()},
                     {values.pulls.data(), values.pulls.size()},
                     flutterPhases(_time, leaf),
                     flutterLimits(leaf),
                     treeRandom(tree.seed)}
        .run(values.leaves.data());
}

} // namespace osgTreeWind
