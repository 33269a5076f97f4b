// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalGroup.h>

#include <osgTreeWind/base/Batches.h>
#include <osgTreeWind/base/ClampOr.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t lanes = TreeLanes::count;
constexpr std::size_t blocksPerJob = 4;
constexpr float longestNearStep = 1.0f / 30.0f; // seconds

} // namespace

/// Places and winds of one job's patches. Each thread keeps one, which a job takes while it is at work: where
/// the wind is sampled the thread may take up another job.
struct ModalMotion::Scratch {
    std::vector<WindPlace> places;
    std::vector<glm::vec3> winds;
    std::vector<TreeLanes> lanes;
};

void ModalMotion::meet(const WindField* wind, double time) {
    _work.clear();
    for (std::uint32_t g = 0; g < _groups.size(); ++g)
        for (std::uint32_t b = 0; b < _groups[g].waiting.size(); ++b)
            _work.push_back({g, b, 0.0f, time});
    advance(wind);
}

/// Near trees step to `time`, far ones to the last time that it was their turn: every farStep seconds, from
/// whenever time began.
void ModalMotion::step(const WindField* wind, double time, float seconds) {
    constexpr auto interval = static_cast<double>(farStep);
    _work.clear();
    for (std::uint32_t g = 0; g < _groups.size(); ++g) {
        Group& group = _groups[g];
        const bool far = group.level != 0;
        for (std::uint32_t b = 0; b < group.waiting.size(); ++b) {
            const double turn = interval * static_cast<double>((g / Archetype::levels + b) % _turns) /
                                static_cast<double>(_turns);
            const double to = far ? interval * std::floor((time - turn) / interval) + turn : time;
            // Of times so great that no double tells them apart from their turn, none.
            const float late = clampOr(static_cast<float>(time - to), -farStep, farStep, 0.0f);
            const float waited = group.waiting[b] + seconds;
            const bool due = !far || waited - late > 0.01f * farStep; // else it was stepped to there
            if (due)
                _work.push_back({g, b, waited - late, to});
            group.waiting[b] = due ? late : waited;
        }
    }
    advance(wind);
}

void ModalMotion::advance(const WindField* wind) {
    runJobs(_executor, (_work.size() + blocksPerJob - 1) / blocksPerJob, [&](std::size_t job) {
        const std::size_t first = job * blocksPerJob, end = std::min(_work.size(), first + blocksPerJob);
        thread_local Scratch kept;
        Scratch scratch = std::move(kept);
        sampleWind(wind, first, end, scratch);
        const glm::vec3* met = scratch.winds.data();
        for (std::size_t w = first; w < end; ++w) {
            Group& group = _groups[_work[w].group];
            const ModalModel& model = group.model();
            const std::size_t patches = model.patches.size();
            const std::size_t trees = group.treesIn(_work[w].block);
            scratch.lanes.assign(3 * patches, TreeLanes());
            for (std::size_t i = 0; i < trees; ++i)
                for (std::size_t p = 0; p < patches; ++p, ++met)
                    for (std::size_t c = 0; c < 3; ++c)
                        scratch.lanes[3 * p + c].tree[i] = (*met)[static_cast<glm::length_t>(c)];
            ModalStep step;
            step.model = &model;
            step.block = group.block(_work[w].block);
            step.wind = scratch.lanes.data();
            step.seconds = _work[w].seconds;
            step.gain = _gain;
            const float longest = group.level == 0 ? longestNearStep : farStep;
            step.substeps = std::max(step.seconds > 0.0f ? 1 : 0,
                                     static_cast<int>(std::ceil(step.seconds / longest - 0.01f)));
            stepTrees(step, _instructions);
            for (std::size_t i = 0; i < trees; ++i)
                refreshLean(group.trees[_work[w].block * lanes + i]);
        }
        kept = std::move(scratch);
    });
}

/// At the patches of a part of the work, at the time of each. @param wind null: calm.
void ModalMotion::sampleWind(const WindField* wind, std::size_t first, std::size_t end,
                             Scratch& scratch) const {
    std::size_t count = 0;
    for (std::size_t w = first; w < end; ++w)
        count +=
            _groups[_work[w].group].treesIn(_work[w].block) * _groups[_work[w].group].model().patches.size();
    if (scratch.places.size() < count) {
        scratch.places.resize(count);
        scratch.winds.resize(count);
    }
    if (!wind)
        std::fill_n(scratch.winds.begin(), count, glm::vec3(0.0f));
    WindPlace *next = scratch.places.data(), *sampled = next;
    for (std::size_t w = first; wind && w < end; ++w) {
        next = addPlaces(_work[w], next);
        if (w + 1 < end && _work[w + 1].time == _work[w].time)
            continue;
        wind->sample(sampled, static_cast<std::size_t>(next - sampled), _work[w].time,
                     scratch.winds.data() + (sampled - scratch.places.data()));
        sampled = next;
    }
}

/// Of the patches of the trees of a block, tree after tree. @return the place after them.
WindPlace* ModalMotion::addPlaces(const Work& work, WindPlace* out) const {
    const Group& group = _groups[work.group];
    const std::size_t factor = group.firstFactor(), trees = group.treesIn(work.block);
    const TreeLanes* numbers = group.block(work.block);
    for (std::size_t i = 0; i < trees; ++i) {
        const Place& place = _places[group.trees[work.block * lanes + i]];
        const float cosine = numbers[factor].tree[i], sine = numbers[factor + 1].tree[i];
        const glm::vec3 axes(place.width, place.width, numbers[factor + 2].tree[i]);
        for (const ModalModel::Patch& patch : group.model().patches) {
            const glm::vec3 at = axes * patch.place;
            *out = WindPlace(place.foot +
                                 glm::vec3(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y, at.z),
                             place.foot.z);
            out++->inCrown = true;
        }
    }
    return out;
}

/// The farther a tree bends the less its top moves: as that of an even arc.
void ModalMotion::refreshLean(std::size_t tree) {
    const Group& group = groupOf(tree);
    const std::vector<glm::vec2>& leans = group.model().leans;
    const std::size_t place = _slots[tree].place, factor = group.firstFactor();
    glm::vec2 lean(0.0f);
    for (std::size_t k = 0; k < leans.size(); ++k)
        lean += group.number(place, k) * leans[k];
    const float height = std::max(group.model().height, 1.0e-6f);
    lean *= shareOfSway(tree) * group.number(place, factor + 2) / // lengths
            std::sqrt(1.0f + glm::dot(lean, lean) / (height * height));
    const float cosine = group.number(place, factor), sine = group.number(place, factor + 1);
    _leans[tree] = {cosine * lean.x - sine * lean.y, sine * lean.x + cosine * lean.y};
}

} // namespace osgTreeWind
