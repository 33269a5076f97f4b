// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/WindDamage.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/damage/TreeStrength.h>
#include <osgTreeWind/species/Season.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr float breastHeightJoint = 1.3f; // metres; TreeStrength
// Share of the stem's limit below which no bough is checked: boughs reach at most 1.2 times the stem's share.
constexpr float minStemShare = 0.3f;
constexpr float fewLeaves = 0.05f; // share of leaves whose loss does not change the sway

/// The trunk unit at whose base a stem snaps: the first joint from breast height on.
unsigned breastHeightUnit(const PlacedForest& forest, const PlacedTree& tree) {
    const std::vector<BranchUnit>& units = forest.modelOf(tree).skeleton.units;
    unsigned joint = 0;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0) {
            joint = static_cast<unsigned>(i);
            if (tree.scale.axes.z * units[i].base.z >= breastHeightJoint)
                break;
        }
    return joint;
}

glm::vec3 meanWind(const ModalMotion& sway, std::size_t slot, const PlacedTree& tree) {
    glm::vec3 winds[ModalDetail::maxPatches];
    sway.patchWinds(slot, winds);
    glm::vec3 sum(0.0f);
    const std::size_t patches = sway.model(slot).patches.size();
    for (std::size_t patch = 0; patch < patches; ++patch)
        sum += winds[patch];
    return rotateAboutZ(sum / static_cast<float>(std::max<std::size_t>(patches, 1)), math::sin(tree.heading),
                        math::cos(tree.heading));
}

} // namespace

WindDamage::Tree WindDamage::makeTree(const PlacedForest& forest, const PlacedTree& tree) {
    const TreeForm form = makeModalTree(forest, tree).form;
    const std::vector<UnitLoad> loads = makeUnitLoads(*form.model, form.scale, *form.species, form.leaves);
    const TreeStrength strength(*form.model, form.scale, *form.species);
    Tree result;
    result.age = 0.0f;
    result.leaves = tree.leaves;
    result.roots.base = {0, loads[0].stiffness, static_cast<float>(strength.uproot)};
    result.stem.base = {breastHeightUnit(forest, tree), loads[0].stiffness,
                        static_cast<float>(strength.breaking)};
    for (const BreakableJoint& bough : thickestBoughs(form, loads))
        result.boughs.push_back({bough});
    return result;
}

void WindDamage::updateTree(PlacedForest& forest, const ModalMotion& sway, std::size_t slot, float seconds) {
    Tree& tree = _trees[slot];
    if (tree.age < 0.0f)
        tree = makeTree(forest, forest.trees[slot]);
    tree.age += seconds;
    if (sway.lean(slot) == tree.lean)
        return;
    tree.lean = sway.lean(slot);
    const ModalMotion::PoseVector vector = sway.poseVector(slot);
    const float exaggeration = exaggerationOf(forest);
    const auto momentAt = [&](const BreakableJoint& base) {
        return static_cast<float>(base.moment(sway, slot, vector)) / exaggeration;
    };
    tree.roots.moment = tree.stem.moment = momentAt(tree.roots.base);
    const bool isLoadLow = tree.stem.moment < minStemShare * tree.stem.base.limit;
    for (Joint& bough : tree.boughs)
        bough.moment = isLoadLow ? 0.0f : momentAt(bough.base);
    const LeafFall& leaves = _leafFalls[forest.trees[slot].species];
    if (!leaves.hasLooseLeaves(forest.season()))
        return;
    tree.shed =
        std::max(tree.shed, leaves.seasonAdvance(glm::length(meanWind(sway, slot, forest.trees[slot]))));
    applyShedding(forest, slot);
}

void WindDamage::applyShedding(PlacedForest& forest, std::size_t slot) const {
    PlacedTree& tree = forest.trees[slot];
    tree.leaves =
        tree.summerLeaves * _leafFalls[tree.species].remainingShare(forest.season(), _trees[slot].shed);
}

void WindDamage::reapplyShedding(PlacedForest& forest) {
    for (std::size_t slot = 0; slot < _trees.size(); ++slot) {
        if (forest.season() < midsummer) // new leaves have grown
            _trees[slot].shed = 0.0f;
        if (forest.trees[slot].alive && _trees[slot].shed > 0.0f)
            applyShedding(forest, slot);
    }
}

std::vector<std::size_t> WindDamage::takeBaredTrees(const PlacedForest& forest, std::size_t most) {
    std::vector<std::size_t> slots;
    for (std::size_t i = 0; i < _trees.size() && slots.size() < most; ++i) {
        _nextBared = (_nextBared + 1) % _trees.size();
        const PlacedTree& tree = forest.trees[_nextBared];
        Tree& known = _trees[_nextBared];
        if (!tree.alive || known.age < 0.0f || known.leaves - tree.leaves < fewLeaves)
            continue;
        known.leaves = tree.leaves;
        slots.push_back(_nextBared);
    }
    return slots;
}

void WindDamage::update(PlacedForest& forest, ModalMotion& sway, float seconds, const Executor& executor) {
    _broken.clear();
    _trees.resize(forest.trees.size());
    for (std::size_t i = _leafFalls.size(); i < forest.description().species.size(); ++i)
        _leafFalls.emplace_back(forest.description().species[i]);
    runInBatches(executor ? executor : Executor(runInTurn), _trees.size(), [&](std::size_t slot) {
        if (forest.trees[slot].alive && !_trees[slot].isDown)
            updateTree(forest, sway, slot, seconds);
    });
    for (std::size_t slot = 0; slot < _trees.size(); ++slot)
        if (forest.trees[slot].alive && !_trees[slot].isDown && _trees[slot].age > settlingTime)
            checkTree(forest, sway, slot);
    for (Falling& falling : _falling) {
        falling.body.step(static_cast<double>(seconds));
        TreeFall fall = *sway.fall(falling.slot);
        fall.parts[falling.part].turn = static_cast<float>(falling.body.angle()) * falling.axis;
        if (fall.isDown && falling.part + 1 == fall.count)
            fall.sway = static_cast<float>(falling.body.swayShare());
        sway.setFall(falling.slot, fall);
    }
    _falling.erase(std::remove_if(_falling.begin(), _falling.end(),
                                  [](const Falling& falling) { return falling.body.isAtRest(); }),
                   _falling.end());
}

/// Checks the joints of an upright tree, and breaks those that fail.
void WindDamage::checkTree(const PlacedForest& forest, ModalMotion& sway, std::size_t slot) {
    Tree& tree = _trees[slot];
    if (tree.roots.fails() || tree.stem.fails()) {
        const bool roots =
            tree.roots.fails() && (!tree.stem.fails() || tree.roots.base.limit < tree.stem.base.limit);
        breakOff(forest, sway, slot, roots ? tree.roots : tree.stem,
                 roots ? DamageKind::Uprooted : DamageKind::Snapped);
        tree.isDown = true;
        return;
    }
    const auto torn = std::find_if(tree.boughs.begin(), tree.boughs.end(),
                                   [](const Joint& bough) { return bough.fails(); });
    if (torn == tree.boughs.end())
        return;
    breakOff(forest, sway, slot, *torn, DamageKind::BoughTorn);
    tree.boughs.erase(torn);
    if (sway.fall(slot)->count + 1 == TreeFall::maxParts) // one part is reserved for the trunk
        tree.boughs.clear();
}

void WindDamage::breakOff(const PlacedForest& forest, ModalMotion& sway, std::size_t slot, const Joint& joint,
                          DamageKind kind) {
    const PlacedTree& tree = forest.trees[slot];
    _broken.push_back({forest.idOf(slot), kind, joint.base.unit, joint.moment, joint.base.limit,
                       meanWind(sway, slot, tree)});

    const bool isBough = kind == DamageKind::BoughTorn;
    const glm::vec2 lean = sway.lean(slot);
    const float length = glm::length(lean);
    const glm::vec2 direction = length > 0.0f ? lean / length : glm::vec2(1.0f, 0.0f);
    const double angle = math::atan(static_cast<double>(length / std::max(forest.sizeOf(tree).height, 0.1f)));
    FallingTree body(makeModalTree(forest, tree).form, joint.base.unit, static_cast<double>(joint.base.limit),
                     isBough ? 0.0 : angle);
    const glm::vec2 leeward(
        rotateAboutZ({-direction.y, direction.x, 0.0f}, -math::sin(tree.heading), math::cos(tree.heading)));
    TreeFall fall = sway.fall(slot) ? *sway.fall(slot) : TreeFall();
    fall.parts[fall.count].unit = joint.base.unit;
    fall.isDown = !isBough;
    _falling.push_back({slot, fall.count++, body, isBough ? body.axis() : leeward});
    sway.setFall(slot, fall);
}

void WindDamage::clearSlot(std::size_t slot) {
    if (slot < _trees.size())
        _trees[slot] = Tree();
    _falling.erase(std::remove_if(_falling.begin(), _falling.end(),
                                  [&](const Falling& falling) { return falling.slot == slot; }),
                   _falling.end());
}

void WindDamage::reset() {
    _trees.clear();
    _falling.clear();
    _broken.clear();
}

} // namespace osgTreeWind
