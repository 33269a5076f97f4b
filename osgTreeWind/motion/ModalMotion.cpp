// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ModalMotion.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/motion/Laws.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t lanes = TreeLanes::count;
constexpr std::size_t blocksPerJob = 4;
constexpr float longestNearStep = 1.0f / 30.0f, longestFarStep = 0.2f; // seconds
constexpr std::size_t factorCount = sizeof(TreeFactors) / sizeof(float);

std::size_t firstFactor(const ModalShape& shape) {
    return treeFloats(shape) - factorCount;
}

/// Places and winds of one job's patches; each thread keeps its own.
struct Scratch {
    std::vector<WindPlace> places;
    std::vector<glm::vec3> winds;
    std::vector<TreeLanes> lanes;
};

} // namespace

/// Trees of one archetype at one level.
struct ModalMotion::Group {
    const Archetype* archetype = nullptr;
    std::size_t level = 0;
    std::vector<TreeLanes> numbers;   ///< Block after block.
    std::vector<std::uint32_t> trees; ///< Which tree is at each place.
    std::vector<float> waiting;       ///< Per block, seconds since its last step.

    const ModalShape& shape() const { return archetype->shape(level); }
    TreeLanes* block(std::size_t index) { return numbers.data() + index * treeFloats(shape()); }
    float& number(std::size_t tree, std::size_t index) {
        return block(tree / lanes)[index].tree[tree % lanes];
    }
};

ModalMotion::ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact)
    : _executor(executor ? std::move(executor) : Executor(runInTurn)),
      _gain(clampOr(gain, 0.0f, 100.0f, 1.0f)), _slots(trees.size()) {
    std::vector<std::uint32_t> archetypes; // per tree
    std::vector<SwayingTree> forms;        // per archetype
    std::map<ArchetypeRung, std::uint32_t> rungs;
    for (const Tree& tree : trees) {
        auto index = static_cast<std::uint32_t>(forms.size());
        if (!exact)
            index = rungs.emplace(nearestRung(tree.form), index).first->second;
        archetypes.push_back(index);
        if (index == forms.size())
            forms.push_back(exact ? tree.form : treeOn(nearestRung(tree.form)));
    }
    _archetypes.resize(forms.size());
    _executor(forms.size(), [&](std::size_t i) { _archetypes[i] = std::make_unique<Archetype>(forms[i]); });
    for (const auto& archetype : _archetypes)
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            _groups.emplace_back();
            _groups.back().archetype = archetype.get();
            _groups.back().level = level;
        }
    std::vector<TreeFactors> factors(trees.size());
    constexpr std::size_t batch = 256;
    _executor((trees.size() + batch - 1) / batch, [&](std::size_t job) {
        for (std::size_t i = job * batch; i < std::min(trees.size(), (job + 1) * batch); ++i)
            factors[i] = _archetypes[archetypes[i]]->factors(trees[i].form, trees[i].heading);
    });
    std::vector<std::size_t> sizes(_groups.size(), 0);
    for (const std::uint32_t archetype : archetypes)
        ++sizes[2 * archetype];
    for (std::size_t g = 0; g < _groups.size(); ++g) {
        const std::size_t blocks = (sizes[g] + lanes - 1) / lanes;
        _groups[g].trees.reserve(sizes[g]);
        _groups[g].waiting.reserve(blocks);
        _groups[g].numbers.reserve(blocks * treeFloats(_groups[g].shape()));
    }
    _places.reserve(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        _places.push_back(
            {trees[i].foot, trees[i].form.scale.axes.x / _archetypes[archetypes[i]]->scale().axes.x});
        put(i, 2 * archetypes[i]);
        float numbers[factorCount];
        std::memcpy(numbers, &factors[i], sizeof numbers);
        for (std::size_t n = 0; n < factorCount; ++n)
            number(i, firstFactor(_groups[_slots[i].group].shape()) + n) = numbers[n];
    }
}

ModalMotion::~ModalMotion() = default;

float& ModalMotion::number(std::size_t tree, std::size_t index) {
    return _groups[_slots[tree].group].number(_slots[tree].index, index);
}

float ModalMotion::number(std::size_t tree, std::size_t index) const {
    return const_cast<ModalMotion*>(this)->number(tree, index);
}

const Archetype& ModalMotion::archetype(std::size_t tree) const {
    return *_groups[_slots[tree].group].archetype;
}

ModalMotion::Level ModalMotion::level(std::size_t tree) const {
    return static_cast<Level>(_groups[_slots[tree].group].level);
}

TreeFactors ModalMotion::factors(std::size_t tree) const {
    const ModalShape& shape = _groups[_slots[tree].group].shape();
    float numbers[factorCount];
    for (std::size_t n = 0; n < factorCount; ++n)
        numbers[n] = number(tree, firstFactor(shape) + n);
    TreeFactors factors;
    std::memcpy(&factors, numbers, sizeof numbers);
    return factors;
}

/// At the end of a group, at rest.
void ModalMotion::put(std::size_t tree, std::uint32_t index) {
    Group& group = _groups[index];
    _slots[tree] = {index, static_cast<std::uint32_t>(group.trees.size())};
    group.trees.push_back(static_cast<std::uint32_t>(tree));
    if (group.trees.size() > group.waiting.size() * lanes) {
        group.waiting.push_back(0.0f);
        const std::size_t size = group.waiting.size() * treeFloats(group.shape());
        if (size > group.numbers.capacity())
            group.numbers.reserve(size + size / 8); // not twice as many: forests are large
        group.numbers.resize(size);
    }
}

/// Out of its group; the last one takes its place.
void ModalMotion::take(std::size_t tree) {
    const Slot slot = _slots[tree];
    Group& group = _groups[slot.group];
    const std::size_t last = group.trees.size() - 1;
    for (std::size_t n = 0; n < treeFloats(group.shape()); ++n) {
        group.number(slot.index, n) = group.number(last, n);
        group.number(last, n) = 0.0f;
    }
    group.trees[slot.index] = group.trees[last];
    _slots[group.trees[last]].index = slot.index;
    group.trees.pop_back();
    if (group.trees.size() <= (group.waiting.size() - 1) * lanes) {
        group.waiting.pop_back();
        group.numbers.resize(group.waiting.size() * treeFloats(group.shape()));
        if (2 * group.numbers.size() < group.numbers.capacity())
            group.numbers.shrink_to_fit();
    }
}

void ModalMotion::setLevel(std::size_t tree, Level wanted) {
    if (level(tree) == wanted)
        return;
    const std::uint32_t before = _slots[tree].group, after = before ^ 1u;
    const ModalShape& from = _groups[before].shape();
    const ModalShape& to = _groups[after].shape();
    std::vector<float> numbers(treeFloats(from));
    for (std::size_t n = 0; n < numbers.size(); ++n)
        numbers[n] = number(tree, n);
    take(tree);
    put(tree, after);
    const std::size_t modes = std::min(from.modes.size(), to.modes.size());
    for (std::size_t k = 0; k < modes; ++k) {
        number(tree, k) = numbers[k];
        number(tree, to.modes.size() + k) = numbers[from.modes.size() + k];
    }
    const std::vector<std::size_t>& nearest = _groups[after].archetype->otherPatches(_groups[after].level);
    for (std::size_t p = 0; p < to.patches.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            number(tree, 2 * to.modes.size() + 3 * p + c) =
                numbers[2 * from.modes.size() + 3 * nearest[p] + c];
    for (std::size_t n = 0; n < factorCount; ++n)
        number(tree, firstFactor(to) + n) = numbers[firstFactor(from) + n];
    if (modes == to.modes.size())
        return;
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    for (std::size_t k = modes; k < to.modes.size(); ++k) { // the new ones are where the air holds them
        float force = 0.0f;
        for (std::size_t i = 0; i < 3 * to.patches.size(); ++i)
            force += to.levers[i * to.modes.size() + k] * vector[to.modes.size() + i];
        number(tree, k) = force / (to.modes[k].pace * to.modes[k].pace);
    }
}

void ModalMotion::meet(const WindField* wind, double time) {
    _work.clear();
    for (std::uint32_t g = 0; g < _groups.size(); ++g)
        for (std::uint32_t b = 0; b < _groups[g].waiting.size(); ++b)
            _work.push_back({g, b, 0.0f});
    advance(wind, time);
}

void ModalMotion::step(const WindField* wind, double time, float seconds) {
    _work.clear();
    ++_turn;
    for (std::uint32_t g = 0; g < _groups.size(); ++g) {
        Group& group = _groups[g];
        for (std::uint32_t b = 0; b < group.waiting.size(); ++b) {
            group.waiting[b] += seconds;
            if (group.level != 0 && (_turn + g / Archetype::levels + b) % farInterval != 0)
                continue;
            _work.push_back({g, b, group.waiting[b]});
            group.waiting[b] = 0.0f;
        }
    }
    advance(wind, time);
}

void ModalMotion::advance(const WindField* wind, double time) {
    _executor((_work.size() + blocksPerJob - 1) / blocksPerJob, [&](std::size_t job) {
        const std::size_t end = std::min(_work.size(), (job + 1) * blocksPerJob);
        thread_local Scratch scratch;
        scratch.places.clear();
        for (std::size_t w = job * blocksPerJob; w < end; ++w)
            addPlaces(_work[w], scratch.places);
        scratch.winds.assign(scratch.places.size(), glm::vec3(0.0f));
        if (wind)
            wind->sample(scratch.places.data(), scratch.places.size(), time, scratch.winds.data());
        const glm::vec3* met = scratch.winds.data();
        for (std::size_t w = job * blocksPerJob; w < end; ++w) {
            Group& group = _groups[_work[w].group];
            const ModalShape& shape = group.shape();
            const std::size_t patches = shape.patches.size();
            const std::size_t trees = std::min(lanes, group.trees.size() - _work[w].block * lanes);
            scratch.lanes.assign(3 * patches, TreeLanes());
            for (std::size_t i = 0; i < trees; ++i)
                for (std::size_t p = 0; p < patches; ++p, ++met)
                    for (std::size_t c = 0; c < 3; ++c)
                        scratch.lanes[3 * p + c].tree[i] = (*met)[static_cast<glm::length_t>(c)];
            ModalStep step;
            step.shape = &shape;
            step.block = group.block(_work[w].block);
            step.wind = scratch.lanes.data();
            step.seconds = _work[w].seconds;
            step.gain = _gain;
            const float longest = group.level == 0 ? longestNearStep : longestFarStep;
            step.substeps = static_cast<int>(std::ceil(step.seconds / longest - 0.01f));
            stepTrees(step, _instructions);
        }
    });
}

/// Of the patches of the trees of a block, tree after tree.
void ModalMotion::addPlaces(const Work& work, std::vector<WindPlace>& places) const {
    const Group& group = _groups[work.group];
    const std::size_t patches = group.shape().patches.size(), factor = firstFactor(group.shape());
    const TreeLanes* numbers = const_cast<Group&>(group).block(work.block);
    const std::size_t first = work.block * lanes, end = std::min(first + lanes, group.trees.size());
    for (std::size_t i = first; i < end; ++i) {
        const Place& place = _places[group.trees[i]];
        const float cosine = numbers[factor].tree[i - first], sine = numbers[factor + 1].tree[i - first];
        const glm::vec3 axes(place.width, place.width, numbers[factor + 2].tree[i - first]);
        for (std::size_t p = 0; p < patches; ++p) {
            const glm::vec3 at = axes * group.shape().patches[p].place;
            places.emplace_back(place.foot +
                                    glm::vec3(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y, at.z),
                                place.foot.z);
        }
    }
}

void ModalMotion::reset() {
    for (Group& group : _groups) {
        const std::size_t count = treeFloats(group.shape());
        for (std::size_t b = 0; b < group.waiting.size(); ++b)
            std::fill_n(group.block(b), count - factorCount, TreeLanes());
        std::fill(group.waiting.begin(), group.waiting.end(), 0.0f);
    }
    _turn = 0;
}

/// What the pose is a matrix times: amplitudes of the modes, forces of the air on the patches.
void ModalMotion::poseVector(std::size_t tree, float* vector) const {
    const ModalShape& shape = _groups[_slots[tree].group].shape();
    const std::size_t modes = shape.modes.size(), patches = shape.patches.size();
    const TreeFactors f = factors(tree);
    Laws laws;
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] = number(tree, k);
    const SizePowers& stiffness = shape.modes.front().stiffness;
    const float reach = _gain > 0.0f ? f.length / _gain : 0.0f;
    const float wooden = std::sqrt(f.pace) * f.length * f.length * f.length;
    const float rest =
        _gain / (wooden * wooden * f.pace) / // gain l / stiffness
        laws.nearExponential(stiffness.modulus * f.logs.modulus + stiffness.branches * f.logs.branches +
                             stiffness.width * f.logs.width + stiffness.leaves * f.logs.leaves);
    for (std::size_t p = 0; p < patches; ++p) {
        const ModalShape::Patch& patch = shape.patches[p];
        glm::vec3 air, own(0.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto axis = static_cast<glm::length_t>(c);
            air[axis] = number(tree, 2 * modes + 3 * p + c);
            for (std::size_t k = 0; k < modes; ++k)
                own[axis] += reach * shape.levers[(3 * p + c) * modes + k] * number(tree, modes + k);
        }
        const float wood = patch.woodDrag * wooden;
        const float drag = (wood + patch.leafDrag * f.leafDrag) *
                           laws.streamlinedShare(patch.streamlining, shape.streamlinedTo, glm::length(air));
        const glm::vec3 relative = air - own;
        const float brake = laws.airBrake(drag, wood + patch.stillDrag * f.stillDrag, glm::dot(air, air),
                                          glm::dot(own, own), glm::dot(relative, relative));
        for (std::size_t c = 0; c < 3; ++c)
            vector[modes + 3 * p + c] = rest * brake * relative[static_cast<glm::length_t>(c)];
    }
}

void ModalMotion::angles(std::size_t tree, glm::vec2* angles) const {
    const ModalShape& shape = _groups[_slots[tree].group].shape();
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    Laws laws;
    const float* row = shape.poses.data();
    for (std::size_t joint = 0; joint < shape.joints; ++joint, row += shape.columns()) {
        float angle = 0.0f;
        for (std::size_t i = 0; i < shape.columns(); ++i)
            angle += row[i] * vector[i];
        angles[joint / 2][static_cast<glm::length_t>(joint % 2)] = laws.bounded(angle, shape.maxAngle);
    }
}

void ModalMotion::setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes) {
    const std::size_t modes = _groups[_slots[tree].group].shape().modes.size();
    for (std::size_t k = 0; k < modes; ++k) {
        number(tree, k) = k < amplitudes.size() ? amplitudes[k] : 0.0f;
        number(tree, modes + k) = 0.0f;
    }
}

std::vector<float> ModalMotion::amplitudes(std::size_t tree) const {
    std::vector<float> result(_groups[_slots[tree].group].shape().modes.size());
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = number(tree, k);
    return result;
}

void ModalMotion::winds(std::size_t tree, glm::vec3* winds) const {
    const ModalShape& shape = _groups[_slots[tree].group].shape();
    const TreeFactors f = factors(tree);
    for (std::size_t unit = 0; unit < shape.patchOfLink.size(); ++unit) {
        const std::size_t first = 2 * shape.modes.size() + 3 * shape.patchOfLink[unit];
        const float x = number(tree, first), y = number(tree, first + 1);
        winds[unit] = {f.cosine * x - f.sine * y, f.sine * x + f.cosine * y, number(tree, first + 2)};
    }
}

std::size_t ModalMotion::stateBytes() const {
    std::size_t bytes = _slots.capacity() * sizeof(Slot) + _places.capacity() * sizeof(Place);
    for (const Group& group : _groups)
        bytes += group.numbers.capacity() * sizeof(TreeLanes) +
                 group.trees.capacity() * sizeof(std::uint32_t) + group.waiting.capacity() * sizeof(float);
    return bytes;
}

std::size_t ModalMotion::archetypeBytes() const {
    std::size_t bytes = 0;
    for (const auto& archetype : _archetypes)
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            const ModalShape& shape = archetype->shape(level);
            bytes += sizeof(float) * (shape.poses.size() + shape.levers.size() + shape.brakes.size()) +
                     sizeof(ModalShape::Mode) * shape.modes.size() +
                     sizeof(ModalShape::Patch) * shape.patches.size();
        }
    return bytes;
}

} // namespace osgTreeWind
