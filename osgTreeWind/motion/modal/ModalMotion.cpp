// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgTreeWind/base/Batches.h>
#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/RoomFor.h>
#include <osgTreeWind/motion/modal/CarriedSway.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr float runUpStep = 0.1f; // seconds

/// Damping ratio of crowns that touch all around. In a stand of Sitka spruces contact took five times what
/// stems did (Milne 1991), and stripped stems have 0.01 at least (Moore and Maguire 2005).
constexpr float contactDamping = 0.05f;

std::size_t groupAt(std::size_t archetype, ModalLevel level) {
    return Archetype::levels * archetype + static_cast<std::size_t>(level);
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
        groups.push_back(groupAt(_archetypes.indexOf(tree.form), tree.level));
    makeArchetypes();
    std::vector<std::size_t> sizes(_state.groups.size(), 0);
    for (const std::size_t group : groups)
        ++sizes[group];
    for (std::size_t i = 0; i < sizes.size(); ++i)
        _state.groups[i].reserve(sizes[i]);
    for (std::size_t i = 0; i < trees.size(); ++i)
        _state.put(i, groups[i]);
    runInBatches(_executor, trees.size(), [&](std::size_t i) { stand(i, trees[i], {}); });
}

void ModalMotion::setExecutor(Executor executor) {
    _executor = executor ? std::move(executor) : Executor(runInTurn);
}

/// With their groups, in order.
void ModalMotion::makeArchetypes() {
    const std::size_t first = _archetypes.size();
    _archetypes.make(_executor);
    for (std::size_t i = first; i < _archetypes.size(); ++i)
        for (std::size_t level = 0; level < Archetype::levels; ++level)
            _state.groups.emplace_back(_archetypes[i], level);
}

std::size_t ModalMotion::prepare(const std::vector<Tree>& trees, std::size_t most) {
    std::size_t ready = 0;
    for (; ready < trees.size(); ++ready) {
        if (_archetypes.missing() == most && _archetypes.isNew(trees[ready].form))
            break;
        _archetypes.indexOf(trees[ready].form);
    }
    makeArchetypes();
    return ready;
}

std::size_t ModalMotion::add(const Tree& tree) {
    std::size_t number = treeCount();
    if (_free.empty()) {
        _state.resize(number + 1);
    } else {
        number = _free.back();
        _free.pop_back();
    }
    const std::size_t group = groupAt(_archetypes.indexOf(tree.form), tree.level);
    makeArchetypes();
    _state.put(number, group);
    stand(number, tree, {});
    _state.refreshLean(number);
    return number;
}

void ModalMotion::remove(std::size_t tree) {
    if (!holds(tree))
        return;
    _state.take(tree);
    _state.leans[tree] = glm::vec2(0.0f);
    putUpright(tree);
    _free.push_back(static_cast<std::uint32_t>(tree));
}

void ModalMotion::replace(std::size_t tree, const Tree& other) {
    const std::size_t before = _state.slots[tree].group;
    const std::size_t after = groupAt(_archetypes.indexOf(other.form), level(tree));
    makeArchetypes();
    const TreeFactors was = factors(tree);
    if (after == before) {
        stand(tree, other, was);
    } else {
        const ModalModel& from = model(tree);
        const std::vector<float> numbers = moveTo(tree, after);
        stand(tree, other, was);
        const CarriedSway sway(from, was.length, model(tree), factors(tree).length);
        for (const std::size_t part : {0, 1}) { // amplitudes, speeds
            const std::vector<float> carried = sway.carried(numbers.data() + part * from.modes.size());
            for (std::size_t k = 0; k < carried.size(); ++k)
                _state.number(tree, part * carried.size() + k) = carried[k];
        }
        setWinds(tree, numbers.data() + 2 * from.modes.size(), sway.patches());
    }
    _state.refreshLean(tree);
}

/// In a calm, at rest, and without its factors. @return all that it had but those.
std::vector<float> ModalMotion::moveTo(std::size_t tree, std::size_t group) {
    std::vector<float> numbers(_state.groupOf(tree).firstFactor());
    for (std::size_t n = 0; n < numbers.size(); ++n)
        numbers[n] = _state.number(tree, n);
    _state.take(tree);
    _state.put(tree, group);
    return numbers;
}

/// The winds at its patches from those at other ones: `patches` says which.
void ModalMotion::setWinds(std::size_t tree, const float* winds, const std::vector<std::size_t>& patches) {
    const std::size_t first = 2 * model(tree).modes.size();
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            _state.number(tree, first + 3 * p + c) = winds[3 * patches[p] + c];
}

/// Its place and its factors, in the company that `company` has.
void ModalMotion::stand(std::size_t tree, const Tree& given, const TreeFactors& company) {
    const Archetype& archetype = this->archetype(tree);
    _state.places[tree] = {given.foot, given.form.scale.axes.x / archetype.scale().axes.x};
    TreeFactors factors = archetype.factors(given.form, given.heading);
    factors.contact = company.contact;
    factors.shelter = company.shelter;
    _state.setFactors(tree, factors);
}

void ModalMotion::setCompany(std::size_t tree, const TreeCompany& company) {
    TreeFactors factors = this->factors(tree);
    factors.contact = contactDamping * clampOr(company.crowns, 0.0f, 1.0f, 0.0f);
    factors.shelter = clampOr(company.shelter, 0.0f, 1.0f, 1.0f);
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
    if (modes < to.modes.size()) { // the air of now gives the amplitudes of the rest
        float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
        poseVector(tree, vector);
        for (std::size_t k = modes; k < to.modes.size(); ++k)
            _state.number(tree, k) = heldAmplitude(tree, k, vector);
    }
    _state.refreshLean(tree);
}

void ModalMotion::setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes) {
    const std::size_t modes = model(tree).modes.size();
    for (std::size_t k = 0; k < modes; ++k) {
        _state.number(tree, k) = k < amplitudes.size() ? amplitudes[k] : 0.0f;
        _state.number(tree, modes + k) = 0.0f;
    }
    _state.refreshLean(tree);
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

void ModalMotion::runUp(const std::vector<std::size_t>& trees, const WindField* wind, double time,
                        float seconds) {
    ModalState apart;
    apart.gain = _state.gain;
    for (const ModalGroup& group : _state.groups)
        apart.groups.emplace_back(*group.archetype, group.level);
    apart.resize(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        apart.places[i] = _state.places[trees[i]];
        apart.put(i, _state.slots[trees[i]].group);
        apart.setFactors(i, factors(trees[i]));
    }
    const int steps = std::max(static_cast<int>(std::ceil(seconds / runUpStep)), 1);
    ModalStepJob job;
    job.state = &apart;
    job.wind = wind;
    job.executor = &_executor;
    job.instructions = _instructions;
    for (int k = 0; k <= steps; ++k) { // the first meets the wind
        const float step = seconds / static_cast<float>(steps);
        job.time = time - static_cast<double>(step) * (steps - k);
        job.seconds = k > 0 ? step : 0.0f;
        job.run();
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (std::size_t n = 0; n < _state.groupOf(trees[i]).firstFactor(); ++n)
            _state.number(trees[i], n) = apart.number(i, n);
        _state.refreshLean(trees[i]);
    }
}

std::size_t ModalMotion::treeBytes(Level level) {
    const ModalDetail& detail = Archetype::details[static_cast<std::size_t>(level)];
    return sizeof(ModalState::Slot) + sizeof(ModalState::Place) + sizeof(glm::vec2) + sizeof(std::uint32_t) +
           treeFloats(detail.modes, detail.patches) * sizeof(float);
}

} // namespace osgTreeWind
