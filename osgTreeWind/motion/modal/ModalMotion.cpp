// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalAir.h>
#include <osgTreeWind/motion/modal/SwayTransfer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr float spinUpStep = 0.1f; // seconds

/// Damping ratio of a crown in contact all around. In a stand of Sitka spruce, contact took five times as
/// much energy as stems did (Milne 1991), and stripped stems have 0.01 at least (Moore and Maguire 2005).
constexpr float contactDamping = 0.05f;

std::size_t groupIndex(std::size_t archetype, ModalLevel level) {
    return Archetype::levels * archetype + static_cast<std::size_t>(level);
}

/// A single tree.
struct OneLane {
    using Number = float;
    using Laws = osgTreeWind::Laws;
    static float every(float x) { return x; }
    static float root(float x) { return std::sqrt(x); }
};

LaneFactors<OneLane> factorsOfTree(const ModalState& state, std::size_t tree) {
    const ModalGroup& group = state.groupOf(tree);
    const std::size_t place = state.slots[tree].place;
    return {{group.block(place / ModalGroup::lanes) + group.firstFactor(), place % ModalGroup::lanes},
            state.gain};
}

} // namespace

ModalMotion::ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact)
    : _archetypes(exact) {
    setExecutor(std::move(executor));
    _state.gain = clampOr(gain, 0.0f, 100.0f, 1.0f);
    _state.resize(trees.size());
    std::vector<std::size_t> groups; // per tree
    groups.reserve(trees.size());
    for (const Tree& tree : trees)
        groups.push_back(groupIndex(_archetypes.indexOf(tree.form), tree.level));
    makeArchetypes();
    std::vector<std::size_t> sizes(_state.groups.size(), 0);
    for (const std::size_t group : groups)
        ++sizes[group];
    for (std::size_t i = 0; i < sizes.size(); ++i)
        _state.groups[i].reserve(sizes[i]);
    for (std::size_t i = 0; i < trees.size(); ++i)
        _state.addToGroup(i, groups[i]);
    runInBatches(_executor, trees.size(), [&](std::size_t i) { placeTree(i, trees[i], {}); });
}

void ModalMotion::setExecutor(Executor executor) {
    _executor = executor ? std::move(executor) : Executor(runInTurn);
}

/// Makes missing archetypes, and their groups in the same order.
void ModalMotion::makeArchetypes() {
    const std::size_t first = _archetypes.size();
    _archetypes.makeMissing(_executor);
    for (std::size_t i = first; i < _archetypes.size(); ++i)
        for (std::size_t level = 0; level < Archetype::levels; ++level)
            _state.groups.emplace_back(_archetypes[i], level);
}

std::size_t ModalMotion::makeArchetypesFor(const std::vector<Tree>& trees, std::size_t most) {
    std::size_t ready = 0;
    for (; ready < trees.size(); ++ready) {
        if (_archetypes.missingCount() == most && _archetypes.isNew(trees[ready].form))
            break;
        _archetypes.indexOf(trees[ready].form);
    }
    makeArchetypes();
    return ready;
}

void ModalMotion::add(std::size_t number, const Tree& tree) {
    _state.resize(std::max(treeCount(), number + 1));
    const std::size_t group = groupIndex(_archetypes.indexOf(tree.form), tree.level);
    makeArchetypes();
    _state.addToGroup(number, group);
    placeTree(number, tree, {});
    _state.updateLean(number);
}

void ModalMotion::remove(std::size_t tree) {
    if (!holds(tree))
        return;
    _state.removeFromGroup(tree);
    _state.leans[tree] = glm::vec2(0.0f);
    clearFall(tree);
}

void ModalMotion::replace(std::size_t tree, const Tree& other) {
    const std::size_t before = _state.slots[tree].group;
    const std::size_t after = groupIndex(_archetypes.indexOf(other.form), level(tree));
    makeArchetypes();
    const TreeFactors was = factors(tree);
    if (after == before) {
        placeTree(tree, other, was);
    } else {
        const ModalModel& from = model(tree);
        const std::vector<float> numbers = moveTo(tree, after);
        placeTree(tree, other, was);
        const SwayTransfer sway(from, was.length, model(tree), factors(tree).length);
        for (const std::size_t part : {0, 1}) { // amplitudes, speeds
            const std::vector<float> transferred = sway.transfer(numbers.data() + part * from.modes.size());
            for (std::size_t k = 0; k < transferred.size(); ++k)
                _state.number(tree, part * transferred.size() + k) = transferred[k];
        }
        setWinds(tree, numbers.data() + 2 * from.modes.size(), sway.patches());
    }
    _state.updateLean(tree);
}

/// Moves a tree to another group, at rest, in calm and with default factors. @return its old state.
std::vector<float> ModalMotion::moveTo(std::size_t tree, std::size_t group) {
    std::vector<float> numbers(_state.groupOf(tree).firstFactor());
    for (std::size_t n = 0; n < numbers.size(); ++n)
        numbers[n] = _state.number(tree, n);
    _state.removeFromGroup(tree);
    _state.addToGroup(tree, group);
    return numbers;
}

/// Sets the wind at the patches of a tree. @param patches per patch, the index into `winds`.
void ModalMotion::setWinds(std::size_t tree, const float* winds, const std::vector<std::size_t>& patches) {
    const std::size_t first = 2 * model(tree).modes.size();
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            _state.number(tree, first + 3 * p + c) = winds[3 * patches[p] + c];
}

/// Sets position and factors of a tree. @param neighbours contact and shelter are taken from these factors.
void ModalMotion::placeTree(std::size_t tree, const Tree& given, const TreeFactors& neighbours) {
    const Archetype& archetype = this->archetype(tree);
    _state.places[tree] = {given.foot, given.form.scale.axes.x / archetype.scale().axes.x};
    TreeFactors factors = archetype.factors(given.form, given.heading);
    factors.contact = neighbours.contact;
    factors.shelter = neighbours.shelter;
    _state.setFactors(tree, factors);
}

void ModalMotion::setNeighbourEffect(std::size_t tree, const NeighbourEffect& neighbours) {
    TreeFactors factors = this->factors(tree);
    factors.contact = contactDamping * clampOr(neighbours.crownCover, 0.0f, 1.0f, 0.0f);
    factors.shelter = clampOr(neighbours.shelter, 0.0f, 1.0f, 1.0f);
    _state.setFactors(tree, factors);
}

void ModalMotion::setLevel(std::size_t tree, Level wanted) {
    if (level(tree) == wanted)
        return;
    const ModalModel& from = model(tree);
    const TreeFactors factors = this->factors(tree);
    const std::vector<float> numbers = moveTo(tree, _state.slots[tree].group ^ 1u);
    const ModalModel& to = model(tree);
    _state.setFactors(tree, factors);
    const std::size_t modes = std::min(from.modes.size(), to.modes.size());
    for (std::size_t k = 0; k < modes; ++k) {
        _state.number(tree, k) = numbers[k];
        _state.number(tree, to.modes.size() + k) = numbers[from.modes.size() + k];
    }
    setWinds(tree, numbers.data() + 2 * from.modes.size(),
             archetype(tree).otherPatches(static_cast<std::size_t>(wanted)));
    if (modes < to.modes.size()) { // additional modes start in equilibrium with the present wind
        const PoseVector vector = poseVector(tree);
        for (std::size_t k = modes; k < to.modes.size(); ++k)
            _state.number(tree, k) = staticAmplitude(tree, k, vector);
    }
    _state.updateLean(tree);
}

void ModalMotion::setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes) {
    const std::size_t modes = model(tree).modes.size();
    for (std::size_t k = 0; k < modes; ++k) {
        _state.number(tree, k) = k < amplitudes.size() ? amplitudes[k] : 0.0f;
        _state.number(tree, modes + k) = 0.0f;
    }
    _state.updateLean(tree);
}

void ModalMotion::step(const WindField* wind, double time, float seconds) {
    ModalStepJob job;
    job.state = &_state;
    job.wind = wind;
    job.time = time;
    job.seconds = seconds;
    job.turns = _turns;
    job.executor = &_executor;
    job.instructions = _instructions;
    job.run();
}

void ModalMotion::spinUp(const std::vector<std::size_t>& trees, const WindField* wind, double time,
                         float seconds) {
    ModalState apart;
    apart.gain = _state.gain;
    for (const ModalGroup& group : _state.groups)
        apart.groups.emplace_back(*group.archetype, group.level);
    apart.resize(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        apart.places[i] = _state.places[trees[i]];
        apart.addToGroup(i, _state.slots[trees[i]].group);
        apart.setFactors(i, factors(trees[i]));
    }
    const int steps = std::max(static_cast<int>(std::ceil(seconds / spinUpStep)), 1);
    ModalStepJob job;
    job.state = &apart;
    job.wind = wind;
    job.executor = &_executor;
    job.instructions = _instructions;
    for (int k = 0; k <= steps; ++k) { // the first step sets the wind
        const float step = seconds / static_cast<float>(steps);
        job.time = time - static_cast<double>(step) * (steps - k);
        job.seconds = k > 0 ? step : 0.0f;
        job.run();
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (std::size_t n = 0; n < _state.groupOf(trees[i]).firstFactor(); ++n)
            _state.number(trees[i], n) = apart.number(i, n);
        _state.updateLean(trees[i]);
    }
}

ModalMotion::PoseVector ModalMotion::poseVector(std::size_t tree, float ahead) const {
    PoseVector vector{};
    const ModalGroup& group = _state.groupOf(tree);
    const ModalModel& model = group.model();
    const std::size_t modes = model.modes.size(), patches = model.patches.size();
    const std::size_t place = _state.slots[tree].place, lane = place % ModalGroup::lanes;
    const TreeLanes* block = group.block(place / ModalGroup::lanes);
    const LaneColumn<OneLane> numbers(block, lane), wind(block + 2 * modes, lane);
    ModalAir<OneLane> air(model, block, lane, _state.gain);
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] = numbers[k] + ahead * numbers[modes + k];
    const LaneFactors<OneLane>& factors = air.factors();
    const float rest = // residual flexibility: gain l / stiffness
        factors.forceScale / (factors.omegaSquare * factors.sizeFactor(model.modes.front().stiffness));
    for (std::size_t p = 0; p < patches; ++p) {
        air.setWind(p, wind[3 * p], wind[3 * p + 1], wind[3 * p + 2]);
        for (std::size_t c = 0; c < 3; ++c)
            vector[modes + 3 * p + c] = rest * air.brake(p) * air.relativeWind(p)[c];
    }
    if (const TreeFall* fall = this->fall(tree))
        for (float& number : vector)
            number *= fall->sway;
    return vector;
}

float ModalMotion::staticAmplitude(std::size_t tree, std::size_t mode, const PoseVector& vector) const {
    const ModalModel& model = this->model(tree);
    const std::size_t modes = model.modes.size();
    const LaneFactors<OneLane> factors = factorsOfTree(_state, tree);
    float force = 0.0f;
    for (std::size_t i = 0; i < 3 * model.patches.size(); ++i)
        force += model.levers[i * modes + mode] * vector[modes + i];
    const ModalModel::Mode& m = model.modes[mode];
    const float left = factors.stiffnessLeft(m, factors.sizeFactor(m.stiffness), factors.sizeFactor(m.mass));
    return force / (m.omega * m.omega * left);
}

float ModalMotion::omega(std::size_t tree, std::size_t mode) const {
    const LaneFactors<OneLane> factors = factorsOfTree(_state, tree);
    const ModalModel::Mode& m = model(tree).modes[mode];
    const float stiffness = factors.sizeFactor(m.stiffness), mass = factors.sizeFactor(m.mass);
    return m.omega *
           std::sqrt(factors.omegaSquare * stiffness * factors.stiffnessLeft(m, stiffness, mass) / mass);
}

void ModalMotion::patchWinds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const float share = _state.swayShare(tree);
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        const std::size_t first = 2 * model.modes.size() + 3 * p;
        winds[p] = share * glm::vec3(_state.number(tree, first), _state.number(tree, first + 1),
                                     _state.number(tree, first + 2));
    }
}

void ModalMotion::angles(std::size_t tree, glm::vec2* angles) const {
    const PoseVector vector = poseVector(tree);
    for (std::size_t unit = 0; unit < model(tree).joints / 2; ++unit)
        angles[unit] = unitAngles(tree, unit, vector);
}

glm::vec2 ModalMotion::unitAngles(std::size_t tree, std::size_t unit, const PoseVector& vector) const {
    const ModalModel& model = this->model(tree);
    const std::size_t columns = model.columns();
    const float* row = model.poses.data() + 2 * unit * columns;
    glm::vec2 angles;
    for (glm::length_t axis = 0; axis < 2; ++axis, row += columns) {
        float angle = 0.0f; // a local sum stays in a register
        for (std::size_t i = 0; i < columns; ++i)
            angle += row[i] * vector[i];
        angles[axis] = Laws().bounded(angle, model.maxAngle);
    }
    return angles;
}

std::vector<float> ModalMotion::amplitudes(std::size_t tree) const {
    std::vector<float> result(this->model(tree).modes.size());
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = _state.number(tree, k);
    return result;
}

void ModalMotion::winds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const TreeFactors f = factors(tree);
    glm::vec3 met[ModalDetail::maxPatches];
    patchWinds(tree, met);
    for (std::size_t unit = 0; unit < model.patchOfLink.size(); ++unit)
        winds[unit] = rotateAboutZ(met[model.patchOfLink[unit]], f.sine, f.cosine);
}

std::size_t ModalMotion::treeBytes(Level level) {
    const ModalDetail& detail = Archetype::details[static_cast<std::size_t>(level)];
    return sizeof(ModalState::Slot) + sizeof(ModalState::Place) + sizeof(glm::vec2) + sizeof(std::uint32_t) +
           treeFloats(detail.modes, detail.patches) * sizeof(float);
}

} // namespace osgTreeWind
