// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgTreeWind/base/Batches.h>
#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/RoomFor.h>
#include <osgTreeWind/motion/modal/CarriedSway.h>
#include <osgTreeWind/motion/modal/ModalGroup.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::uint32_t noGroup = ~0u;
constexpr float runUpStep = 0.1f; // seconds

/// Damping ratio of crowns that touch all around. In a stand of Sitka spruces contact took five times what
/// stems did (Milne 1991), and stripped stems have 0.01 at least (Moore and Maguire 2005).
constexpr float contactDamping = 0.05f;

} // namespace

ModalMotion::Group::Numbers ModalMotion::Group::numbersOf(std::size_t place) const {
    Numbers values{};
    for (std::size_t n = 0; n < firstFactor(); ++n)
        values[n] = number(place, n);
    return values;
}

void ModalMotion::Group::setWinds(std::size_t place, const float* winds,
                                  const std::vector<std::size_t>& patches) {
    const std::size_t first = 2 * model().modes.size();
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            number(place, first + 3 * p + c) = winds[3 * patches[p] + c];
}

void ModalMotion::Group::reserve(std::size_t count) {
    const std::size_t blocks = (count + lanes - 1) / lanes;
    trees.reserve(count);
    waiting.reserve(blocks);
    numbers.reserve(blocks * treeFloats(model()));
}

std::size_t ModalMotion::Group::add(std::uint32_t tree) {
    makeRoomFor(trees, trees.size() + 1);
    trees.push_back(tree);
    if (trees.size() > waiting.size() * lanes) {
        makeRoomFor(waiting, waiting.size() + 1);
        waiting.push_back(0.0f);
        const std::size_t size = waiting.size() * treeFloats(model());
        makeRoomFor(numbers, size);
        numbers.resize(size);
    }
    return trees.size() - 1;
}

void ModalMotion::Group::remove(std::size_t place) {
    const std::size_t last = trees.size() - 1;
    for (std::size_t n = 0; n < treeFloats(model()); ++n) {
        number(place, n) = number(last, n);
        number(last, n) = 0.0f;
    }
    trees[place] = trees[last];
    trees.pop_back();
    if (trees.size() <= (waiting.size() - 1) * lanes) {
        waiting.pop_back();
        numbers.resize(waiting.size() * treeFloats(model()));
        if (2 * numbers.size() < numbers.capacity())
            numbers.shrink_to_fit();
    }
}

ModalMotion::ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact)
    : _gain(clampOr(gain, 0.0f, 100.0f, 1.0f)), _exact(exact), _slots(trees.size()), _places(trees.size()),
      _leans(trees.size(), glm::vec2(0.0f)) {
    setExecutor(std::move(executor));
    std::vector<std::uint32_t> archetypes; // per tree
    std::vector<SwayingTree> forms;        // per archetype
    for (const Tree& tree : trees) {
        auto index = static_cast<std::uint32_t>(forms.size());
        if (!exact)
            index = _rungs.emplace(nearestRung(tree.form), index).first->second;
        archetypes.push_back(index);
        if (index == forms.size())
            forms.push_back(exact ? tree.form : treeOn(nearestRung(tree.form)));
    }
    addArchetypes(forms);
    const auto groupOf = [&](std::size_t tree) {
        return Archetype::levels * archetypes[tree] + static_cast<std::size_t>(trees[tree].level);
    };
    std::vector<std::size_t> sizes(_groups.size(), 0);
    for (std::size_t i = 0; i < trees.size(); ++i)
        ++sizes[groupOf(i)];
    for (std::size_t i = 0; i < sizes.size(); ++i)
        _groups[i].reserve(sizes[i]);
    for (std::size_t i = 0; i < trees.size(); ++i)
        put(i, groupOf(i));
    runInBatches(_executor, trees.size(), [&](std::size_t i) { stand(i, trees[i], {}); });
}

ModalMotion::ModalMotion(const ModalMotion& other) = default;
ModalMotion::~ModalMotion() = default;

void ModalMotion::setExecutor(Executor executor) {
    _executor = executor ? std::move(executor) : Executor(runInTurn);
}

/// With their groups, in order.
void ModalMotion::addArchetypes(const std::vector<SwayingTree>& forms) {
    std::vector<std::shared_ptr<const Archetype>> made(forms.size());
    runJobs(_executor, forms.size(), [&](std::size_t i) { made[i] = sharedArchetype(forms[i]); });
    for (std::shared_ptr<const Archetype>& archetype : made) {
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            _groups.emplace_back();
            _groups.back().archetype = archetype.get();
            _groups.back().level = level;
        }
        _archetypes.push_back(std::move(archetype));
    }
}

std::uint32_t ModalMotion::archetypeOf(const SwayingTree& form) {
    const auto next = static_cast<std::uint32_t>(_archetypes.size());
    const std::uint32_t index = _exact ? next : _rungs.emplace(nearestRung(form), next).first->second;
    if (index == next)
        addArchetypes({_exact ? form : treeOn(nearestRung(form))});
    return index;
}

std::size_t ModalMotion::prepare(const std::vector<Tree>& trees, std::size_t most) {
    std::vector<SwayingTree> missing;
    std::size_t ready = 0;
    for (; ready < trees.size(); ++ready) {
        const ArchetypeRung rung = nearestRung(trees[ready].form);
        if (_rungs.count(rung) > 0)
            continue;
        if (missing.size() == most)
            break;
        _rungs.emplace(rung, static_cast<std::uint32_t>(_archetypes.size() + missing.size()));
        missing.push_back(treeOn(rung));
    }
    addArchetypes(missing);
    return ready;
}

std::size_t ModalMotion::add(const Tree& tree) {
    std::size_t number = _slots.size();
    if (_free.empty()) {
        makeRoomFor(_slots, number + 1);
        makeRoomFor(_places, number + 1);
        makeRoomFor(_leans, number + 1);
        _slots.emplace_back();
        _places.emplace_back();
        _leans.emplace_back(0.0f);
    } else {
        number = _free.back();
        _free.pop_back();
        _places[number] = Place();
    }
    put(number, Archetype::levels * archetypeOf(tree.form) + static_cast<std::size_t>(tree.level));
    stand(number, tree, {});
    refreshLean(number);
    return number;
}

void ModalMotion::remove(std::size_t tree) {
    if (!holds(tree))
        return;
    take(tree);
    putUpright(tree);
    _slots[tree] = Slot();
    _leans[tree] = glm::vec2(0.0f);
    _free.push_back(static_cast<std::uint32_t>(tree));
}

bool ModalMotion::holds(std::size_t tree) const {
    return tree < _slots.size() && _slots[tree].group != noGroup;
}

void ModalMotion::replace(std::size_t tree, const Tree& other) {
    const std::uint32_t before = _slots[tree].group;
    const auto after =
        static_cast<std::uint32_t>(Archetype::levels * archetypeOf(other.form) + _groups[before].level);
    if (after == before) {
        stand(tree, other, factors(tree));
        refreshLean(tree);
        return;
    }
    const Group::Numbers numbers = groupOf(tree).numbersOf(_slots[tree].place);
    const ModalModel& from = _groups[before].model();
    const ModalModel& to = _groups[after].model();
    const TreeFactors was = factors(tree);
    take(tree);
    put(tree, after);
    stand(tree, other, was);
    const CarriedSway sway(from, was.length, to, factors(tree).length);
    for (const std::size_t part : {0, 1}) { // amplitudes, speeds
        const std::vector<float> carried = sway.carried(numbers.data() + part * from.modes.size());
        for (std::size_t k = 0; k < carried.size(); ++k)
            number(tree, part * carried.size() + k) = carried[k];
    }
    _groups[after].setWinds(_slots[tree].place, numbers.data() + 2 * from.modes.size(), sway.patches());
    refreshLean(tree);
}

const ModalMotion::Group& ModalMotion::groupOf(std::size_t tree) const {
    return _groups[_slots[tree].group];
}

float& ModalMotion::number(std::size_t tree, std::size_t index) {
    return _groups[_slots[tree].group].number(_slots[tree].place, index);
}

float ModalMotion::number(std::size_t tree, std::size_t index) const {
    return groupOf(tree).number(_slots[tree].place, index);
}

void ModalMotion::put(std::size_t tree, std::size_t group) {
    _slots[tree] = {static_cast<std::uint32_t>(group),
                    static_cast<std::uint32_t>(_groups[group].add(static_cast<std::uint32_t>(tree)))};
}

void ModalMotion::take(std::size_t tree) {
    const Slot slot = _slots[tree];
    Group& group = _groups[slot.group];
    _slots[group.trees.back()].place = slot.place;
    group.remove(slot.place);
}

/// Its place and its factors, in the company that `company` has.
void ModalMotion::stand(std::size_t tree, const Tree& given, const TreeFactors& company) {
    const Slot slot = _slots[tree];
    Group& group = _groups[slot.group];
    Place& place = _places[tree];
    place.foot = given.foot;
    place.width = given.form.scale.axes.x / group.archetype->scale().axes.x;
    TreeFactors factors = group.archetype->factors(given.form, given.heading);
    factors.contact = company.contact;
    factors.shelter = company.shelter;
    group.setFactors(slot.place, factors);
}

void ModalMotion::setCompany(std::size_t tree, const TreeCompany& company) {
    TreeFactors factors = this->factors(tree);
    factors.contact = contactDamping * clampOr(company.crowns, 0.0f, 1.0f, 0.0f);
    factors.shelter = clampOr(company.shelter, 0.0f, 1.0f, 1.0f);
    _groups[_slots[tree].group].setFactors(_slots[tree].place, factors);
}

void ModalMotion::setLevel(std::size_t tree, Level wanted) {
    if (level(tree) == wanted)
        return;
    const std::uint32_t before = _slots[tree].group, after = before ^ 1u;
    const ModalModel& from = _groups[before].model();
    const ModalModel& to = _groups[after].model();
    const Group::Numbers numbers = groupOf(tree).numbersOf(_slots[tree].place);
    const TreeFactors factors = this->factors(tree);
    take(tree);
    put(tree, after);
    _groups[after].setFactors(_slots[tree].place, factors);
    const std::size_t modes = std::min(from.modes.size(), to.modes.size());
    for (std::size_t k = 0; k < modes; ++k) {
        number(tree, k) = numbers[k];
        number(tree, to.modes.size() + k) = numbers[from.modes.size() + k];
    }
    _groups[after].setWinds(_slots[tree].place, numbers.data() + 2 * from.modes.size(),
                            _groups[after].archetype->otherPatches(_groups[after].level));
    settle(tree, modes);
    refreshLean(tree);
}

void ModalMotion::setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes) {
    const std::size_t modes = model(tree).modes.size();
    for (std::size_t k = 0; k < modes; ++k) {
        number(tree, k) = k < amplitudes.size() ? amplitudes[k] : 0.0f;
        number(tree, modes + k) = 0.0f;
    }
    refreshLean(tree);
}

void ModalMotion::runUp(const std::vector<std::size_t>& trees, const WindField* wind, double time,
                        float seconds) {
    ModalMotion apart({}, _gain, _executor, _exact);
    apart._archetypes = _archetypes;
    for (const Group& group : _groups) {
        apart._groups.emplace_back();
        apart._groups.back().archetype = group.archetype;
        apart._groups.back().level = group.level;
    }
    for (const std::size_t tree : trees) {
        const std::size_t number = apart._slots.size();
        apart._slots.emplace_back();
        apart._places.push_back(_places[tree]);
        apart._leans.emplace_back(0.0f);
        apart.put(number, _slots[tree].group);
        apart._groups[_slots[tree].group].setFactors(apart._slots[number].place, factors(tree));
    }
    const int steps = std::max(static_cast<int>(std::ceil(seconds / runUpStep)), 1);
    const float step = seconds / static_cast<float>(steps);
    const auto at = [&](int k) { return time - static_cast<double>(step) * (steps - k); };
    apart.meet(wind, at(0));
    for (int k = 1; k <= steps; ++k)
        apart.step(wind, at(k), step);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (std::size_t n = 0; n < groupOf(trees[i]).firstFactor(); ++n)
            number(trees[i], n) = apart.number(i, n);
        refreshLean(trees[i]);
    }
}

void ModalMotion::reset() {
    for (Group& group : _groups) {
        const std::size_t count = treeFloats(group.model());
        for (std::size_t b = 0; b < group.waiting.size(); ++b)
            std::fill_n(group.block(b), count - factorCount, TreeLanes());
        std::fill(group.waiting.begin(), group.waiting.end(), 0.0f);
    }
    std::fill(_leans.begin(), _leans.end(), glm::vec2(0.0f));
    _falls.clear();
}

} // namespace osgTreeWind
